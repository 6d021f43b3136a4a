import type { Stream } from '../api/types';

/** Index of the last entry not later than t; -1 before the first. `times` ascends. */
export function indexAt(times: readonly number[], t: number): number {
  let low = 0;
  let high = times.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (times[middle] <= t) low = middle + 1;
    else high = middle;
  }
  return low - 1;
}

/** Which entries stay when there is no more room: the newest quarter whole, every other one of what is older. One can
 *  still go back to the beginning, in coarser steps the longer ago it is. */
export function thinned(count: number): number[] {
  const whole = count - (count >> 2);
  const stay: number[] = [];
  for (let i = 0; i < count; i += i < whole ? 2 : 1) stay.push(i);
  return stay;
}

const kFirstRows = 256;

/** One robot's values over time, in one block of numbers that never grows beyond `most_bytes`. Of columns that are not
 *  `kept` only the newest row is known. */
export class RowTrack {
  readonly columns: ReadonlyMap<string, number>;
  times: number[] = [];
  /** Where in a kept row each column is; -1 = nowhere. */
  private readonly places: Int32Array;
  private readonly kept: number[];
  private readonly most: number;
  private data: Float64Array;
  private newest: Float64Array = new Float64Array(0);

  constructor(
    readonly stream: Stream,
    most_bytes: number,
    keep: (column: string) => boolean = () => true,
  ) {
    const names = stream.columns.map((column) => column.name);
    this.columns = new Map(names.map((name, i) => [name, i]));
    this.kept = names.flatMap((name, i) => (keep(name) ? [i] : []));
    this.places = new Int32Array(names.length).fill(-1);
    this.kept.forEach((column, i) => {
      this.places[column] = i;
    });
    this.most = Math.max(4, Math.floor(most_bytes / 8 / (this.kept.length + 1)));
    this.data = new Float64Array(Math.min(kFirstRows, this.most) * this.kept.length);
  }

  get length(): number {
    return this.times.length;
  }

  at(t: number): number {
    return indexAt(this.times, t);
  }

  /** NaN where there is none. */
  value(row: number, column: number): number {
    if (row === this.times.length - 1) return this.newest[column] ?? Number.NaN;
    const place = this.places[column] ?? -1;
    return place < 0 || row < 0 ? Number.NaN : (this.data[row * this.kept.length + place] ?? Number.NaN);
  }

  add(t: number, values: Float64Array): void {
    if (this.times.length >= this.most) this.thin();
    const width = this.kept.length;
    const start = this.times.length * width;
    if (start + width > this.data.length) this.grow();
    for (let i = 0; i < width; i += 1) this.data[start + i] = values[this.kept[i]];
    this.times.push(t);
    this.newest = values;
  }

  private grow(): void {
    const rows = Math.min(this.most, 2 * Math.max(kFirstRows, this.times.length));
    const more = new Float64Array(rows * this.kept.length);
    more.set(this.data);
    this.data = more;
  }

  private thin(): void {
    const width = this.kept.length;
    const stay = thinned(this.times.length);
    stay.forEach((row, i) => {
      this.data.copyWithin(i * width, row * width, (row + 1) * width);
    });
    this.times = stay.map((row) => this.times[row]);
  }
}
