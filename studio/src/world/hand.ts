import { type PointerEvent, useEffect, useRef } from 'react';
import { player, usePlayer } from '../state/player';
import { cellAt, goalCell_m, type Intent, mayReach, maySetGoal, moverAt, moverPose, putObstacle, setGoal } from './reach';
import type { View } from './view';

type Point = [number, number];

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

/** Pointers on the canvas: a drag moves the view or an obstacle, two zoom, a click sets the goal. */
export function useHand(view: { current: View | null }, intent: { current: Intent }) {
  const pointers = useRef(new Map<number, Point>());
  const gesture = useRef<Gesture | null>(null);

  const point = (event: PointerEvent): Point => {
    const box = event.currentTarget.getBoundingClientRect();
    return view.current?.metres(event.clientX - box.left, event.clientY - box.top) ?? [0, 0];
  };
  const grasp = (event: PointerEvent) => {
    const { timeline } = usePlayer.getState();
    if (!timeline || !mayReach()) return undefined;
    const reach_m = event.pointerType === 'touch' ? kTouch_px / (view.current?.scale ?? 1) : 0;
    return moverAt(timeline, timeline.end, point(event), reach_m);
  };
  const forget = () => {
    gesture.current = null;
    intent.current = { cell: null, ghost: null };
    player.wake();
  };

  const down = (event: PointerEvent<HTMLCanvasElement>) => {
    pointers.current.set(event.pointerId, [event.clientX, event.clientY]);
    event.currentTarget.setPointerCapture(event.pointerId);
    if (pointers.current.size > 1 || event.button > 0) return forget(); // two fingers zoom and do nothing else
    const { timeline } = usePlayer.getState();
    const mover = grasp(event);
    const [x, y] = point(event);
    const [px, py] = timeline && mover ? moverPose(timeline, mover, timeline.end) : [x, y];
    const held = mover?.id ? { mover: mover.id, grip: [px - x, py - y] as Point } : null;
    gesture.current = { from: [event.clientX, event.clientY], moved: false, over: false, held };
  };

  const hover = (event: PointerEvent<HTMLCanvasElement>) => {
    const { timeline, robot } = usePlayer.getState();
    const mover = grasp(event);
    const cell_m = maySetGoal() && !mover ? goalCell_m(timeline, robot) : null;
    const cell = cell_m ? cellAt(point(event), cell_m) : null;
    event.currentTarget.style.cursor = mover ? 'move' : cell ? 'crosshair' : '';
    if (`${cell}` === `${intent.current.cell}`) return;
    intent.current = { ...intent.current, cell };
    player.wake();
  };

  const drag = (event: PointerEvent<HTMLCanvasElement>, before: Point, now: Point) => {
    const one = gesture.current;
    if (one?.over) return;
    if (one && Math.hypot(now[0] - one.from[0], now[1] - one.from[1]) > kClick_px) one.moved = true;
    if (one && !one.moved) return;
    if (one?.held) {
      const [x, y] = point(event);
      const { mover, grip } = one.held;
      intent.current = { cell: null, ghost: { mover, at: [x + grip[0], y + grip[1]] } };
    } else view.current?.panBy(now[0] - before[0], now[1] - before[1]);
  };

  const move = (event: PointerEvent<HTMLCanvasElement>) => {
    const before = pointers.current.get(event.pointerId);
    if (!before) return hover(event);
    if (!view.current) return;
    const others = [...pointers.current].filter(([id]) => id !== event.pointerId);
    const now: Point = [event.clientX, event.clientY];
    if (others.length === 0) drag(event, before, now);
    else {
      const [, other] = others[0];
      const apart = (at: Point) => Math.hypot(at[0] - other[0], at[1] - other[1]);
      view.current.zoomBy(apart(now) / (apart(before) || 1));
    }
    const still = others.length === 0 && gesture.current && !gesture.current.moved;
    if (!still) pointers.current.set(event.pointerId, now);
    player.wake();
  };

  const up = (event: PointerEvent<HTMLCanvasElement>) => {
    const one = gesture.current;
    pointers.current.delete(event.pointerId);
    const { ghost } = intent.current;
    gesture.current = null;
    if (!one || !mayReach()) return forget();
    if (one.held && ghost) return void putObstacle(ghost.mover, ghost.at).then(forget); // the ghost stays until it is answered
    if (!one.moved && !one.held && maySetGoal()) void setGoal(point(event));
    forget();
  };

  const cancel = (event: PointerEvent) => {
    pointers.current.delete(event.pointerId);
    forget();
  };
  const leave = () => {
    if (pointers.current.size === 0) forget();
  };

  // Escape lets go of what is held.
  useEffect(() => {
    const let_go = (event: KeyboardEvent) => {
      if (event.key !== 'Escape' || !gesture.current) return;
      gesture.current = { ...gesture.current, moved: true, over: true, held: null };
      intent.current = { cell: null, ghost: null };
      player.wake();
    };
    addEventListener('keydown', let_go);
    return () => removeEventListener('keydown', let_go);
  }, [intent]);

  return { onPointerDown: down, onPointerMove: move, onPointerUp: up, onPointerCancel: cancel, onPointerLeave: leave };
}
