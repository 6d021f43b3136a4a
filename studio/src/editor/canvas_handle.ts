import type { ReactFlowInstance } from '@xyflow/react';
import { useDocument } from '../state/document';
import type { ComponentNode, WireEdge } from './graph';
import type { Point } from './placing';

// What commands and other panes need of the canvas that is on the page, if one is.
let flow: ReactFlowInstance<ComponentNode, WireEdge> | null = null;
let frame: () => HTMLElement | null = () => null;

export function setCanvas(made: ReactFlowInstance<ComponentNode, WireEdge>, at: () => HTMLElement | null): () => void {
  flow = made;
  frame = at;
  return () => {
    if (flow === made) flow = null;
  };
}

export function fit(): void {
  void flow?.fitView({ padding: 0.1, maxZoom: 1 });
}

export function focusCanvas(): void {
  frame()?.focus();
}

/** Brings a component into sight without changing the zoom much. */
export function reveal(id: string): void {
  void flow?.fitView({ nodes: [{ id }], padding: 1, maxZoom: 1, minZoom: 0.5 });
}

export function nodes(): ComponentNode[] {
  return flow?.getNodes() ?? [];
}

export function places(ids: readonly string[]): Map<string, Point> {
  const wanted = new Set(ids);
  return new Map(
    nodes()
      .filter((node) => wanted.has(node.id))
      .map((node) => [node.id, [node.position.x, node.position.y]]),
  );
}

export function selectedEdges(): WireEdge[] {
  return flow?.getEdges().filter((edge) => edge.selected) ?? [];
}

let added = 0;

/** A free-looking place near the middle of what is in sight, each a little further on. */
export function middle(): Point {
  const box = frame()?.getBoundingClientRect();
  if (!flow || !box) {
    added += 1;
    return [40 * added, 40 * added];
  }
  const { x, y } = flow.screenToFlowPosition({ x: box.left + box.width / 2, y: box.top + box.height / 2 });
  const taken = nodes().map((node) => `${node.position.x},${node.position.y}`);
  let at: Point = [Math.round((x - 115) / 10) * 10, Math.round((y - 60) / 10) * 10];
  while (taken.includes(`${at[0]},${at[1]}`)) at = [at[0] + 30, at[1] + 30];
  return at;
}

export function selectionPlaces(): Map<string, Point> {
  return places(useDocument.getState().selection);
}
