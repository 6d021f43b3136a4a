import { type FieldWords, kUnknown } from '../api/exhibits';
import type { FieldChange } from '../api/samples';
import { indexAt } from './rows';

const kChangeBytes = 300; // what a change takes besides its cells

function sizeOf(field: FieldChange): number {
  return kChangeBytes + field.cells.byteLength + field.values.byteLength;
}

/** A field as it stood at one time: layers behind each other in `values`, cell by cell. */
export interface FieldState {
  columns: number;
  rows: number;
  origin: [number, number];
  layers: number;
  values: Uint8Array;
  words: FieldWords;
  /** Which change it is at: another number, another picture. */
  version: number;
}

/** Cells of a whole field that hold anything, as a change from nothing. */
function wholeOf(state: FieldState): FieldChange {
  const { columns, rows, origin, layers, values, words } = state;
  const cells: number[] = [];
  for (let cell = 0; cell < columns * rows; cell += 1) {
    for (let layer = 0; layer < layers; layer += 1) {
      if (values[cell * layers + layer] === kUnknown) continue;
      cells.push(cell);
      break;
    }
  }
  const copied = new Uint8Array(cells.length * layers);
  cells.forEach((cell, i) => {
    copied.set(values.subarray(cell * layers, (cell + 1) * layers), i * layers);
  });
  return { columns, rows, origin, layers, cells: Uint32Array.from(cells), values: copied, words };
}

/** Applies changes on the way to a time; on the way back it begins anew at the last whole field. When all changes together
 *  are too many, the older half becomes one field, and what was before it is shown as that. */
export class FieldTrack {
  private times: number[] = [];
  private values: { base: number; field: FieldChange }[] = [];
  private bytes = 0;
  private shown = -1;
  private changes = 0;
  private state: FieldState | null = null;
  /** The newest, for who offers a choice of layers. */
  words: FieldWords | null = null;

  constructor(private readonly most_bytes: number) {}

  add(t: number, base: number, field: FieldChange): void {
    this.times.push(t);
    this.values.push({ base, field });
    this.words = field.words ?? this.words;
    this.bytes += sizeOf(field);
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
    this.values = [{ base: 0, field: wholeOf(state) }, ...this.values.slice(last + 1)];
    this.bytes = this.values.reduce((sum, one) => sum + sizeOf(one.field), 0);
    this.state = null;
    this.shown = -1;
  }

  at(t: number): FieldState | null {
    const wanted = indexAt(this.times, t);
    if (wanted === this.shown) return this.state;
    const start = wanted > this.shown ? this.shown + 1 : 0;
    this.shown = wanted;
    if (wanted < 0) this.state = null;
    let from = Math.max(wanted, start);
    while (from > start && this.values[from].base !== 0) from -= 1;
    for (let i = from; i <= wanted; i += 1) this.apply(this.values[i].base, this.values[i].field);
    return this.state;
  }

  private apply(base: number, field: FieldChange): void {
    const size = field.columns * field.rows * field.layers;
    this.changes += 1;
    if (base === 0 || !this.state || this.state.values.length !== size) {
      const { columns, rows, origin, layers } = field;
      const words = field.words ?? this.state?.words ?? this.words;
      if (!words) return;
      const values = new Uint8Array(size).fill(kUnknown);
      this.state = { columns, rows, origin, layers, values, words, version: this.changes };
    }
    const { values, layers } = this.state;
    field.cells.forEach((cell, i) => {
      for (let layer = 0; layer < layers; layer += 1) values[cell * layers + layer] = field.values[i * layers + layer];
    });
    this.state.version = this.changes;
  }
}
