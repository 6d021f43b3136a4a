import { type PointerEvent, useEffect, useRef, useState } from 'react';
import { player } from '../state/player';
import { Grasp, type Point } from './grasp';
import type { Intent } from './reach';
import type { View } from './view';

type CanvasPointer = PointerEvent<HTMLCanvasElement>;

function apart(a: Point, b: Point): number {
  return Math.hypot(a[0] - b[0], a[1] - b[1]);
}

/** Pointers on the canvas: a drag moves the view or what is grasped, two zoom, a click sets the goal. */
export function useHand(view: { current: View | null }, intent: { current: Intent }) {
  const pointers = useRef(new Map<number, Point>());
  const [grasp] = useState(() => new Grasp(view, intent));

  const down = (event: CanvasPointer) => {
    pointers.current.set(event.pointerId, [event.clientX, event.clientY]);
    event.currentTarget.setPointerCapture(event.pointerId);
    if (pointers.current.size > 1 || event.button > 0) return grasp.forget(); // two fingers zoom and do nothing else
    grasp.take(event);
  };
  const move = (event: CanvasPointer) => {
    const before = pointers.current.get(event.pointerId);
    if (!before) return grasp.hover(event);
    if (!view.current) return;
    const other = [...pointers.current].find(([id]) => id !== event.pointerId)?.[1];
    const now: Point = [event.clientX, event.clientY];
    const goes = other ? 'zooms' : grasp.drag(event);
    if (other) view.current.zoomBy(apart(now, other) / (apart(before, other) || 1));
    else if (goes === 'free') view.current.panBy(now[0] - before[0], now[1] - before[1]);
    if (goes !== 'waits') pointers.current.set(event.pointerId, now);
    player.wake();
  };
  const up = (event: CanvasPointer) => {
    pointers.current.delete(event.pointerId);
    grasp.letGo(event);
  };
  const cancel = (event: CanvasPointer) => {
    pointers.current.delete(event.pointerId);
    grasp.forget();
  };
  const leave = () => {
    if (pointers.current.size === 0) grasp.forget();
  };

  // Escape lets go of what is held.
  useEffect(() => {
    const letGo = (event: KeyboardEvent) => event.key === 'Escape' && grasp.giveUp();
    addEventListener('keydown', letGo);
    return () => removeEventListener('keydown', letGo);
  }, [grasp]);

  return { onPointerDown: down, onPointerMove: move, onPointerUp: up, onPointerCancel: cancel, onPointerLeave: leave };
}
