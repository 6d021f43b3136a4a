import type { PointerEvent } from 'react';
import type { Shape } from '../api/types';
import { player, usePlayer } from '../state/player';
import {
  cellAt,
  goalCell_m,
  type Intent,
  mayReach,
  maySetGoal,
  moverAt,
  moverPose,
  putObstacle,
  setGoal,
} from './reach';
import type { View } from './view';

export type Point = [number, number];

const kClick_px = 6;
const kTouch_px = 10;

/** One gesture, from the first pointer down to the last one up. */
interface Gesture {
  from: Point;
  moved: boolean;
  /** Nothing comes of it any more. */
  over: boolean;
  /** An obstacle held, and where on it. */
  held: { mover: string; grip: Point } | null;
}

/** What one pointer reaches for in the world: it drags an obstacle, or sets the goal by a click. */
export class Grasp {
  private gesture: Gesture | null = null;

  constructor(
    private readonly view: { current: View | null },
    private readonly intent: { current: Intent },
  ) {}

  take(event: PointerEvent): void {
    const { timeline } = usePlayer.getState();
    const mover = this.under(event);
    const [x, y] = this.point(event);
    const [px, py] = timeline && mover ? moverPose(timeline, mover, timeline.end) : [x, y];
    const held = mover?.id ? { mover: mover.id, grip: [px - x, py - y] as Point } : null;
    this.gesture = { from: [event.clientX, event.clientY], moved: false, over: false, held };
  }

  /** Shows what a click or a drag would do, before any. */
  hover(event: PointerEvent<HTMLElement>): void {
    const { timeline, robot } = usePlayer.getState();
    const mover = this.under(event);
    const cell_m = maySetGoal() && !mover ? goalCell_m(timeline, robot) : null;
    const cell = cell_m ? cellAt(this.point(event), cell_m) : null;
    event.currentTarget.style.cursor = mover ? 'move' : cell ? 'crosshair' : '';
    if (`${cell}` === `${this.intent.current.cell}`) return;
    this.intent.current = { ...this.intent.current, cell };
    player.wake();
  }

  /** "waits": it may still become a click; "free": nothing is held, so that the way is the view's. */
  drag(event: PointerEvent): 'waits' | 'held' | 'free' {
    const one = this.gesture;
    if (!one) return 'free';
    if (one.over) return 'held';
    if (Math.hypot(event.clientX - one.from[0], event.clientY - one.from[1]) > kClick_px) one.moved = true;
    if (!one.moved) return 'waits';
    if (!one.held) return 'free';
    const [x, y] = this.point(event);
    const { mover, grip } = one.held;
    this.intent.current = { cell: null, ghost: { mover, at: [x + grip[0], y + grip[1]] } };
    return 'held';
  }

  letGo(event: PointerEvent): void {
    const one = this.gesture;
    const { ghost } = this.intent.current;
    this.gesture = null;
    const may = one !== null && mayReach();
    if (may && one.held && ghost) {
      void putObstacle(ghost.mover, ghost.at).then(() => this.forget()); // the ghost stays until it is answered
      return;
    }
    if (may && !one.moved && !one.held && maySetGoal()) void setGoal(this.point(event));
    this.forget();
  }

  /** The pointer is still down, but nothing comes of it any more. */
  giveUp(): void {
    if (!this.gesture) return;
    this.gesture = { ...this.gesture, moved: true, over: true, held: null };
    this.show({ cell: null, ghost: null });
  }

  forget(): void {
    this.gesture = null;
    this.show({ cell: null, ghost: null });
  }

  private show(intent: Intent): void {
    this.intent.current = intent;
    player.wake();
  }

  private point(event: PointerEvent): Point {
    const box = event.currentTarget.getBoundingClientRect();
    return this.view.current?.metres(event.clientX - box.left, event.clientY - box.top) ?? [0, 0];
  }

  private under(event: PointerEvent): Shape | undefined {
    const { timeline } = usePlayer.getState();
    if (!timeline || !mayReach()) return undefined;
    const reach_m = event.pointerType === 'touch' ? kTouch_px / (this.view.current?.scale ?? 1) : 0;
    return moverAt(timeline, timeline.end, this.point(event), reach_m);
  }
}
