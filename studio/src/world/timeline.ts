import type { GridChange, Sample } from '../api/samples';
import type { GoalEvent, Info, InterventionEvent, LogEvent, Scene, Stream } from '../api/types';

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

/** Things that each hold from their time on. */
class Track<T> {
  readonly times: number[] = [];
  readonly values: T[] = [];

  add(t: number, value: T): void {
    this.times.push(t);
    this.values.push(value);
  }

  at(t: number): T | undefined {
    return this.values[indexAt(this.times, t)];
  }

  /** Forgets the oldest half. */
  halve(): void {
    const half = this.times.length >> 1;
    this.times.splice(0, half);
    this.values.splice(0, half);
  }
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

/** Applies changes on the way to a time; on the way back it begins anew at the last whole map. */
class MapTrack {
  private readonly track = new Track<{ base: number; grid: GridChange }>();
  private shown = -1;
  private state: MapState | null = null;

  add(t: number, base: number, grid: GridChange): void {
    this.track.add(t, { base, grid });
  }

  at(t: number): MapState | null {
    const wanted = indexAt(this.track.times, t);
    if (wanted === this.shown) return this.state;
    const start = wanted > this.shown ? this.shown + 1 : 0;
    this.shown = wanted;
    if (wanted < 0) this.state = null;
    let from = Math.max(wanted, start);
    while (from > start && this.track.values[from].base !== 0) from -= 1;
    for (let i = from; i <= wanted; i += 1) this.apply(this.track.values[i].base, this.track.values[i].grid, i);
    return this.state;
  }

  private apply(base: number, grid: GridChange, version: number): void {
    const size = grid.columns * grid.rows * grid.layers;
    if (base === 0 || !this.state || this.state.values.length !== size) {
      const { columns, rows, origin, cell_m, layers } = grid;
      this.state = { columns, rows, origin, cell_m, layers, values: new Uint8Array(size), version };
    }
    const { values, layers } = this.state;
    grid.cells.forEach((cell, i) => {
      for (let layer = 0; layer < layers; layer += 1) values[cell * layers + layer] = grid.values[i * layers + layer];
    });
    this.state.version = version;
  }
}

export interface RowTrack {
  stream: Stream;
  columns: Map<string, number>;
  rows: Track<Float64Array>;
}

const kMostRows = 120_000;

export type Mover = { id: string; x_m: number; y_m: number; yaw_rad: number };

/** All that is known of one run: live runs grow it, recordings fill it at once, and both are looked at by time. */
export class Timeline {
  readonly robots: RowTrack[] = [];
  readonly maps: { topic: string; layers: string[]; track: MapTrack }[] = [];
  readonly paths: { topic: string; track: Track<Float64Array> }[] = [];
  readonly movers = new Track<Mover[]>();
  readonly goals: GoalEvent[] = [];
  readonly logs: LogEvent[] = [];
  readonly interventions: InterventionEvent[] = [];
  end = 0;
  private readonly takers = new Map<number, (sample: Sample) => void>();

  constructor(
    streams: Stream[],
    readonly scene: Scene | null,
    readonly info: Info | null,
  ) {
    this.addStreams(streams);
  }

  /** Those that are new: maps and routes may come to a run that goes on. */
  addStreams(streams: Stream[]): void {
    for (const stream of streams) {
      if (!this.takers.has(stream.stream)) this.takers.set(stream.stream, this.taker(stream));
    }
  }

  private taker(stream: Stream): (sample: Sample) => void {
    if (stream.kind === 'row') {
      const columns = new Map(stream.columns.map((column, i) => [column.name, i]));
      const robot = { stream, columns, rows: new Track<Float64Array>() };
      this.robots.push(robot);
      return (sample) => {
        if (sample.kind !== 'row') return;
        if (robot.rows.times.length >= kMostRows) robot.rows.halve();
        robot.rows.add(sample.t, sample.values);
      };
    }
    if (stream.kind === 'grid') {
      const track = new MapTrack();
      this.maps.push({ topic: stream.topic, layers: stream.layers, track });
      return (sample) => sample.kind === 'grid' && track.add(sample.t, sample.base, sample.grid);
    }
    if (stream.kind === 'path') {
      const track = new Track<Float64Array>();
      this.paths.push({ topic: stream.topic, track });
      return (sample) => sample.kind === 'path' && track.add(sample.t, sample.points);
    }
    return (sample) => sample.kind === 'movers' && this.movers.add(sample.t, sample.movers);
  }

  add(sample: Sample): void {
    this.takers.get(sample.stream)?.(sample);
    this.end = Math.max(this.end, sample.t);
  }

  addEvent(event: GoalEvent | InterventionEvent | LogEvent): void {
    if (event.event === 'goal') this.goals.push(event);
    else if (event.event === 'log') this.logs.push(event);
    else {
      this.interventions.push(event);
      this.end = Math.max(this.end, event.time_s); // it is told at once, before the tick it counts for
    }
  }

  /** A robot's value at a time; NaN where there is none. */
  value(robot: number, column: string, t: number): number {
    const track = this.robots[robot];
    const index = track?.columns.get(column);
    return index === undefined ? Number.NaN : (track.rows.at(t)?.[index] ?? Number.NaN);
  }

  /** Times of one robot's rows: what a step goes along. */
  get times(): readonly number[] {
    return this.robots[0]?.rows.times ?? [];
  }
}
