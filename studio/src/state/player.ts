import { create } from 'zustand';
import { writeValues } from './live_values';
import { indexAt } from './rows';
import type { Timeline } from './timeline';

interface Shown {
  timeline: Timeline | null;
  /** A run that goes on: its end moves. */
  growing: boolean;
  /** Shows the newest; otherwise `t` stands, or moves at `speed`. */
  following: boolean;
  playing: boolean;
  speed: number;
  /** For the slider and its words: ten times a second is enough. */
  t: number;
  end: number;
  robot: number;
  /** Counts what was told between samples: a run that waits tells of goals too. */
  told: number;
}

export const usePlayer = create<Shown>(() => ({
  timeline: null,
  growing: false,
  following: true,
  playing: false,
  speed: 1,
  t: 0,
  end: 0,
  robot: 0,
  told: 0,
}));

const { getState: get, setState: set } = usePlayer;
const kTell_ms = 100;

type Painter = (timeline: Timeline, t: number, robot: number) => void;

/** Owns the time that is looked at, apart from the run: the view may stand while the run goes on. */
class Player {
  private t = 0;
  private frame = 0;
  private before_ms = 0;
  private told_ms = 0;
  private readonly painters = new Set<Painter>();

  show(timeline: Timeline, growing: boolean): void {
    this.t = growing ? timeline.end : (timeline.times[0] ?? 0);
    set({ timeline, growing, following: growing, playing: false, t: this.t, end: timeline.end, robot: 0 });
    this.wake();
  }

  /** The same run, better known: the time that is looked at stays. */
  replace(timeline: Timeline): void {
    set({ timeline, end: timeline.end });
    this.wake();
  }

  addPainter(painter: Painter): () => void {
    this.painters.add(painter);
    this.wake();
    return () => this.painters.delete(painter);
  }

  /** Something changed: draw at the next frame of the screen, once. */
  wake(): void {
    if (this.frame || typeof requestAnimationFrame === 'undefined') return;
    this.frame = requestAnimationFrame((ms) => this.draw(ms));
  }

  /** An event came: whoever lists them looks again. */
  tellEvent(): void {
    set(({ told }) => ({ told: told + 1 }));
    this.wake();
  }

  seek(t: number): void {
    const { timeline } = get();
    this.t = Math.max(0, Math.min(timeline?.end ?? 0, t));
    set({ following: false, t: this.t });
    this.wake();
  }

  /** Along the rows of the run: one tick on, or back. */
  step(by: number): void {
    const times = get().timeline?.times ?? [];
    const at = Math.max(0, Math.min(times.length - 1, indexAt(times, this.t + 1e-9) + by));
    if (times.length > 0) this.seek(times[at]);
    set({ playing: false });
  }

  play(playing: boolean): void {
    const { timeline } = get();
    if (playing && timeline && this.t >= timeline.end - 1e-9) this.t = timeline.times[0] ?? 0;
    this.before_ms = 0;
    set({ playing, following: false });
    this.wake();
  }

  follow(following: boolean): void {
    set({ following, playing: false });
    this.wake();
  }

  private draw(ms: number): void {
    this.frame = 0;
    const { timeline, following, playing, speed, robot } = get();
    if (!timeline) return;
    if (following) this.t = timeline.end;
    else if (playing) this.advance(ms, timeline.end, speed);
    this.before_ms = ms;
    for (const painter of this.painters) painter(timeline, this.t, robot);
    writeValues(timeline, this.t, robot);
    if (ms - this.told_ms >= kTell_ms || !playing) this.tell(ms, timeline.end);
    if (get().playing) this.wake();
  }

  private advance(ms: number, end: number, speed: number): void {
    if (this.before_ms > 0) this.t = Math.min(end, this.t + (speed * (ms - this.before_ms)) / 1000);
    if (this.t >= end) set({ playing: false });
  }

  private tell(ms: number, end: number): void {
    const shown = get();
    if (shown.t === this.t && shown.end === end) return;
    if (ms - this.told_ms < kTell_ms && shown.following) {
      setTimeout(() => this.wake(), kTell_ms);
      return;
    }
    this.told_ms = ms;
    set({ t: this.t, end });
  }
}

export const player = new Player();
