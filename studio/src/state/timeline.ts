import type { Exhibit, Whose } from '../api/exhibits';
import type { Sample } from '../api/samples';
import type { Info, InterventionEvent, LogEvent, Scene, Stream } from '../api/types';
import { FieldTrack } from './field_track';
import { indexAt, RowTrack, thinned } from './rows';

/** Things that each hold from their time on. */
class Track<T> {
  times: number[] = [];
  values: T[] = [];

  constructor(private readonly most: number) {}

  add(t: number, value: T): void {
    if (this.times.length >= this.most) {
      const stay = thinned(this.times.length);
      this.times = stay.map((i) => this.times[i]);
      this.values = stay.map((i) => this.values[i]);
    }
    this.times.push(t);
    this.values.push(value);
  }

  at(t: number): T | undefined {
    return this.values[indexAt(this.times, t)];
  }
}

// What a run that goes on for hours may take: what is older is kept in coarser steps.
const kRowBytes = 24 << 20; // of all robots together
const kLeastRows = 1800; // if each robot can have fewer, only the first keeps all of its columns
const kFieldBytes = 16 << 20;
const kMostMoves = 4000;
const kMostStates = 4000; // of one thing that is shown
const kMostEvents = 10_000;

export type Mover = { id: string; x_m: number; y_m: number; yaw_rad: number };

/** To the end of a list that forgets its oldest half where it gets too long. */
function append<T>(list: T[], one: T): void {
  if (list.length >= kMostEvents) list.splice(0, kMostEvents / 2);
  list.push(one);
}

/** All that is known of one run: live runs grow it, recordings fill it at once, and both are looked at by time. */
export class Timeline {
  readonly robots: RowTrack[] = [];
  readonly fields: { of: Whose; track: FieldTrack }[] = [];
  readonly exhibits: { of: Whose; track: Track<Exhibit> }[] = [];
  readonly movers = new Track<Mover[]>(kMostMoves);
  readonly logs: LogEvent[] = [];
  readonly interventions: InterventionEvent[] = [];
  end = 0;
  /** Nothing is to come that it does not have. */
  complete = false;
  private readonly takers = new Map<number, (sample: Sample) => void>();

  constructor(
    streams: Stream[],
    readonly scene: Scene | null,
    readonly info: Info | null,
  ) {
    this.addStreams(streams);
  }

  /** Those that are new: what is shown may come to a run that goes on. */
  addStreams(streams: Stream[]): void {
    const fresh = streams.filter((stream) => !this.takers.has(stream.stream));
    const rows = fresh.filter((stream) => stream.kind === 'row');
    const width = rows.reduce((sum, stream) => sum + stream.columns.length, 0);
    const fits = width * 8 * kLeastRows <= kRowBytes;
    for (const stream of fresh) this.takers.set(stream.stream, this.taker(stream, rows.length, fits));
  }

  /** Of the others in a crowd: what the picture of the world needs. */
  private rowTrack(stream: Stream, robots: number, fits: boolean): RowTrack {
    const index = this.robots.length;
    if (fits) return new RowTrack(stream, kRowBytes / robots);
    if (index === 0) return new RowTrack(stream, kRowBytes / 2);
    const seen = new Set(this.info?.robots[index]?.sensors.map((sensor) => sensor.signal));
    return new RowTrack(stream, kRowBytes / 2 / robots, (name) => name.startsWith('truth.') || seen.has(name));
  }

  private taker(stream: Stream, robots: number, fits: boolean): (sample: Sample) => void {
    if (stream.kind === 'row') {
      const track = this.rowTrack(stream, robots, fits);
      this.robots.push(track);
      return (sample) => sample.kind === 'row' && track.add(sample.t, sample.values);
    }
    const { of } = stream;
    if (stream.kind === 'field' && of) {
      const track = new FieldTrack(kFieldBytes);
      this.fields.push({ of, track });
      return (sample) => sample.kind === 'field' && track.add(sample.t, sample.base, sample.field);
    }
    if (stream.kind === 'exhibit' && of) {
      const track = new Track<Exhibit>(kMostStates);
      this.exhibits.push({ of, track });
      return (sample) => sample.kind === 'exhibit' && track.add(sample.t, sample.exhibit);
    }
    return (sample) => sample.kind === 'movers' && this.movers.add(sample.t, sample.movers);
  }

  add(sample: Sample): void {
    this.takers.get(sample.stream)?.(sample);
    this.end = Math.max(this.end, sample.t);
  }

  addEvent(event: InterventionEvent | LogEvent): void {
    if (event.event === 'log') append(this.logs, event);
    else {
      append(this.interventions, event);
      this.end = Math.max(this.end, event.time_s); // it is told at once, before the tick it counts for
    }
  }

  /** A robot's value at a time; NaN where there is none. */
  value(robot: number, column: string, t: number): number {
    const track = this.robots[robot];
    const index = track?.columns.get(column);
    return index === undefined ? Number.NaN : track.value(track.at(t), index);
  }

  /** Seconds between two rows where none is missing, as far as can be told from those that came. */
  private tick(): number {
    let least = Number.POSITIVE_INFINITY;
    for (let i = 1; i < this.times.length; i += 1) least = Math.min(least, this.times[i] - this.times[i - 1]);
    return least;
  }

  /** Whether all rows of so long a run are here, but for a few that time did not allow for. */
  isWhole(time_s: number): boolean {
    return this.times.length > 1 && this.times.length >= 0.98 * (time_s / this.tick());
  }

  /** What all rows of so long a run would take. */
  bytesOf(time_s: number): number {
    const columns = this.robots.reduce((sum, robot) => sum + robot.columns.size, 0);
    return (8 * columns * time_s) / this.tick();
  }

  /** Times of one robot's rows: what a step goes along. */
  get times(): readonly number[] {
    return this.robots[0]?.times ?? [];
  }
}
