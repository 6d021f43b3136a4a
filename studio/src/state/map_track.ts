import type { GridChange } from '../api/samples';
import { indexAt } from './rows';

const kChangeBytes = 300; // what a change takes besides its cells

function sizeOf(grid: GridChange): number {
  return kChangeBytes + grid.cells.byteLength + grid.values.byteLength;
}

/** A learned map as it stood at one time: layers behind each other in `values`, cell by cell. */
export interface MapState {
  columns: number;
  rows: number;
  origin: [number, number];
  cell_m: number;
  layers: number;
  values: Uint8Array;
  /** Which change it is at: another number, another picture. */
  version: number;
}

/** Cells of a whole map that hold anything, as a change from nothing. */
function wholeOf(state: MapState): GridChange {
  const { columns, rows, origin, cell_m, layers, values } = state;
  const cells: number[] = [];
  for (let cell = 0; cell < columns * rows; cell += 1) {
    for (let layer = 0; layer < layers; layer += 1) {
      if (values[cell * layers + layer] === 0) continue;
      cells.push(cell);
      break;
    }
  }
  const copied = new Uint8Array(cells.length * layers);
  cells.forEach((cell, i) => {
    copied.set(values.subarray(cell * layers, (cell + 1) * layers), i * layers);
  });
  return { columns, rows, origin, cell_m, layers, cells: Uint32Array.from(cells), values: copied };
}

/** Applies changes on the way to a time; on the way back it begins anew at the last whole map. When all changes together
 *  are too many, the older half becomes one map, and what was before it is shown as that. */
export class MapTrack {
  private times: number[] = [];
  private values: { base: number; grid: GridChange }[] = [];
  private bytes = 0;
  private shown = -1;
  private changes = 0;
  private state: MapState | null = null;

  constructor(private readonly most_bytes: number) {}

  add(t: number, base: number, grid: GridChange): void {
    this.times.push(t);
    this.values.push({ base, grid });
    this.bytes += sizeOf(grid);
    if (this.bytes > this.most_bytes && this.times.length > 2) this.fold();
  }

  private fold(): void {
    const last = this.times.length >> 1;
    this.state = null;
    this.shown = -1;
    const state = this.at(this.times[last]);
    if (!state) return;
    const first = this.times[0];
    this.times = [first, ...this.times.slice(last + 1)];
    this.values = [{ base: 0, grid: wholeOf(state) }, ...this.values.slice(last + 1)];
    this.bytes = this.values.reduce((sum, one) => sum + sizeOf(one.grid), 0);
    this.state = null;
    this.shown = -1;
  }

  at(t: number): MapState | null {
    const wanted = indexAt(this.times, t);
    if (wanted === this.shown) return this.state;
    const start = wanted > this.shown ? this.shown + 1 : 0;
    this.shown = wanted;
    if (wanted < 0) this.state = null;
    let from = Math.max(wanted, start);
    while (from > start && this.values[from].base !== 0) from -= 1;
    for (let i = from; i <= wanted; i += 1) this.apply(this.values[i].base, this.values[i].grid);
    return this.state;
  }

  private apply(base: number, grid: GridChange): void {
    const size = grid.columns * grid.rows * grid.layers;
    this.changes += 1;
    if (base === 0 || !this.state || this.state.values.length !== size) {
      const { columns, rows, origin, cell_m, layers } = grid;
      this.state = { columns, rows, origin, cell_m, layers, values: new Uint8Array(size), version: this.changes };
    }
    const { values, layers } = this.state;
    grid.cells.forEach((cell, i) => {
      for (let layer = 0; layer < layers; layer += 1) values[cell * layers + layer] = grid.values[i * layers + layer];
    });
    this.state.version = this.changes;
  }
}
