import type { Scene, Shape } from '../api/types';
import type { Mover } from '../state/timeline';
import type { View, WorldColours } from './view';

export function trace(view: View, shape: Shape, pose?: readonly [number, number, number]): void {
  if (shape.points) view.polygon(shape.points, shape.closed ?? true, pose);
  else view.disc(pose?.[0] ?? shape.x ?? 0, pose?.[1] ?? shape.y ?? 0, (shape.radius ?? 0) * view.scale);
}

/** Floor and what stands on it for good: walls dark, other static obstacles white, as in figure 7. */
export function drawGround(view: View, scene: Scene, colours: WorldColours): void {
  const [x0, y0, x1, y1] = scene.bounds;
  view.polygon(
    [
      [x0, y0],
      [x1, y0],
      [x1, y1],
      [x0, y1],
    ],
    true,
  );
  view.fill(colours.floor);
  view.stroke(colours.line, 1);
  for (const zone of scene.floor ?? []) {
    trace(view, zone);
    view.stroke(colours.line, 1, [1, 3]);
  }
  for (const bump of scene.bumps ?? []) {
    view.polygon(bump, false);
    view.stroke(colours.bump, 1.6, [8, 3, 2, 3]);
  }
  if (scene.map) drawMapRectangles(view, scene.map, colours);
  for (const shape of scene.shapes) {
    if (shape.class === 'wall' || shape.closed === false) continue;
    trace(view, shape);
    view.fill(colours.free);
  }
}

function drawMapRectangles(view: View, map: NonNullable<Scene['map']>, colours: WorldColours): void {
  const { context } = view;
  const cell = map.resolution * view.scale;
  for (const [rectangles, colour] of [
    [map.unknown, colours.mover],
    [map.occupied, colours.wall],
  ] as const) {
    context.save();
    context.translate(view.x(map.origin[0]), view.y(map.origin[1]));
    context.rotate(-map.origin[2]);
    context.beginPath();
    for (const [column, row, columns, rows] of rectangles)
      context.rect(column * cell, -(row + rows) * cell, columns * cell, rows * cell);
    context.fillStyle = colour;
    context.fill();
    context.restore();
  }
}

/** Over the learned map, so that the two can be compared. */
export function drawEdges(view: View, scene: Scene, colours: WorldColours): void {
  for (const shape of scene.shapes) {
    trace(view, shape);
    if (shape.class === 'wall' && shape.closed && shape.kind !== 'wall') view.fill(colours.wall);
    view.stroke(shape.class === 'wall' ? colours.wall : colours.line, shape.class === 'wall' ? 2.5 : 1.2);
  }
}

/** What moves: grey. */
export function drawMovers(view: View, scene: Scene, movers: Mover[] | undefined, colours: WorldColours): void {
  for (const shape of scene.movers) {
    const now = movers?.find((mover) => mover.id === shape.id);
    trace(view, { ...shape, closed: true }, now ? [now.x_m, now.y_m, now.yaw_rad] : (shape.pose ?? [0, 0, 0]));
    view.fill(colours.mover);
    view.stroke(colours.line, 1.2);
  }
}
