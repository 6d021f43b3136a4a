import type { Component } from '../api/types';

export type Point = [number, number];

export interface Box {
  id: string;
  height: number;
  /** Boxes whose wires come in within the tick. */
  from: string[];
}

const kColumn = 370;
const kGap = 34;
const kSweeps = 4;

export function boxesOf(components: Component[], heightOf: (component: Component) => number): Box[] {
  return components.map((component) => ({
    id: component.id,
    height: heightOf(component),
    from: component.inputs.flatMap((input) =>
      input.wires.filter((wire) => !wire.previous && wire.from !== component.id).map((wire) => wire.from),
    ),
  }));
}

/** The longest way to each box along wires: what feeds stands to the left of what is fed. Circles are cut. */
function columnsOf(boxes: Box[]): Map<string, number> {
  const byId = new Map(boxes.map((box) => [box.id, box]));
  const columns = new Map<string, number>();
  const under = new Set<string>();
  const visit = (box: Box): number => {
    const known = columns.get(box.id);
    if (known !== undefined) return known;
    if (under.has(box.id)) return 0;
    under.add(box.id);
    let column = 0;
    for (const id of box.from) {
      const source = byId.get(id);
      if (source) column = Math.max(column, visit(source) + 1);
    }
    under.delete(box.id);
    columns.set(box.id, column);
    return column;
  };
  for (const box of boxes) visit(box);
  return columns;
}

function stack(lists: Box[][], middles: Map<string, number>): void {
  for (const list of lists) {
    const height = list.reduce((sum, box) => sum + box.height + kGap, -kGap);
    let y = -height / 2;
    for (const box of list) {
      middles.set(box.id, y + box.height / 2);
      y += box.height + kGap;
    }
  }
}

/** Orders each column by the mean height of what its boxes are wired to, there and back again. */
function untangle(lists: Box[][], boxes: Box[], middles: Map<string, number>): void {
  const neighbours = new Map<string, string[]>(boxes.map((box) => [box.id, [...box.from]]));
  for (const box of boxes) for (const id of box.from) neighbours.get(id)?.push(box.id);
  const wanted = (box: Box) => {
    const known = (neighbours.get(box.id) ?? []).flatMap((id) => middles.get(id) ?? []);
    return known.length > 0 ? known.reduce((sum, y) => sum + y, 0) / known.length : (middles.get(box.id) ?? 0);
  };
  for (let sweep = 0; sweep < kSweeps; sweep += 1) {
    for (const list of sweep % 2 === 0 ? lists : [...lists].reverse()) {
      const order = new Map(list.map((box) => [box.id, wanted(box)]));
      list.sort((a, b) => (order.get(a.id) ?? 0) - (order.get(b.id) ?? 0));
      stack([list], middles);
    }
  }
}

/** A place for every box, left to right along the wires: milliseconds for a thousand of them. */
export function arrange(boxes: Box[]): Map<string, Point> {
  const columns = columnsOf(boxes);
  const lists: Box[][] = [];
  for (const box of boxes) {
    const column = columns.get(box.id) ?? 0;
    lists[column] = lists[column] ?? [];
    lists[column].push(box);
  }
  const middles = new Map<string, number>();
  const dense = lists.filter(Boolean);
  stack(dense, middles);
  untangle(dense, boxes, middles);
  const places = new Map<string, Point>();
  for (const box of boxes) {
    const y = (middles.get(box.id) ?? 0) - box.height / 2;
    places.set(box.id, [(columns.get(box.id) ?? 0) * kColumn, Math.round(y / 10) * 10]);
  }
  return places;
}

/** Places for boxes that have none, below those that have. */
export function arrangeMissing(boxes: Box[], known: ReadonlyMap<string, Point>): Map<string, Point> {
  const missing = boxes.filter((box) => !known.has(box.id));
  const places = arrange(missing);
  if (known.size === 0 || missing.length === 0) return places;
  const placed = boxes.filter((box) => known.has(box.id));
  const left = Math.min(...placed.map((box) => known.get(box.id)?.[0] ?? 0));
  const below = Math.max(...placed.map((box) => (known.get(box.id)?.[1] ?? 0) + box.height)) + 2 * kGap;
  const top = Math.min(...[...places.values()].map(([, y]) => y));
  for (const [id, [x, y]] of places) places.set(id, [x + left, y - top + below]);
  return places;
}
