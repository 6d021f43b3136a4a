import { kForms, roleLook } from '../api/exhibits';
import type { Language } from '../api/types';
import { followedBy, type PlacedShape } from '../state/frames';
import type { View, WorldColours } from './view';

const kInk = '#22272e';
const kDisc_px = 7; // of a disc without a size

export function drawCross(context: View['context'], x: number, y: number, size: number): void {
  context.beginPath();
  for (const side of [-1, 1]) {
    context.moveTo(x - size, y - size * side);
    context.lineTo(x + size, y + size * side);
  }
}

function points({ shape, pose }: PlacedShape): [number, number][] {
  const list: [number, number][] = [];
  for (let i = 0; i + 1 < shape.xy.length; i += 2) {
    const at = followedBy(pose, { x: shape.xy[i], y: shape.xy[i + 1], yaw: 0 });
    list.push([at.x, at.y]);
  }
  return list;
}

function fillAndStroke(view: View, role: string, colour: string, closed: boolean): void {
  const look = roleLook(role);
  const { context } = view;
  const before = context.globalAlpha;
  if (closed) {
    context.globalAlpha = before * (look.filled ? 0.45 : 0.12);
    view.fill(colour);
    context.globalAlpha = before;
  }
  view.stroke(colour, 2, look.dash);
}

/** A disc of what is over is hollow. */
function drawDisc(view: View, role: string, colour: string, [x, y]: [number, number], radius_px: number): void {
  const look = roleLook(role);
  view.disc(x, y, radius_px);
  if (look.filled && !look.over) {
    view.fill(colour);
    view.stroke(kInk, 1.5);
  } else {
    fillAndStroke(view, role, colour, !look.over);
  }
  if (look.sign !== 'cross') return;
  drawCross(view.context, view.x(x), view.y(y), radius_px * 0.5);
  view.stroke(look.over ? colour : kInk, 1.8);
}

function drawShape(view: View, placed: PlacedShape, colours: WorldColours): void {
  const { shape, pose, radius } = placed;
  const colour = colours.roles[shape.role] ?? colours.line;
  const all = points(placed);
  const [first] = all;
  if (!first) return;
  const { context } = view;
  context.globalAlpha = roleLook(shape.role).over ? 0.7 : 1;
  if (shape.form === kForms.polyline || shape.form === kForms.polygon) {
    view.polygon(all, shape.form === kForms.polygon);
    fillAndStroke(view, shape.role, colour, shape.form === kForms.polygon);
  } else if (shape.form === kForms.disc) {
    drawDisc(view, shape.role, colour, first, Math.max(radius * view.scale, shape.radius ? 4 : kDisc_px));
  } else if (shape.form === kForms.sector) {
    const half = (shape.angle ?? 0) / 2;
    context.beginPath();
    context.moveTo(view.x(first[0]), view.y(first[1]));
    context.arc(view.x(first[0]), view.y(first[1]), radius * view.scale, -(pose.yaw + half), -(pose.yaw - half));
    context.closePath();
    fillAndStroke(view, shape.role, colour, true);
  } else if (shape.form === kForms.point) {
    view.disc(first[0], first[1], 4);
    view.fill(colour);
  }
  context.globalAlpha = 1;
}

function drawLabel(view: View, placed: PlacedShape, language: Language, colours: WorldColours): void {
  const { shape } = placed;
  if (!shape.label) return;
  const inside = shape.form === kForms.disc;
  if (inside && roleLook(shape.role).over) return;
  const all = points(placed);
  const x = all.reduce((sum, [px]) => sum + view.x(px), 0) / all.length;
  const y = all.reduce((sum, [, py]) => sum + view.y(py), 0) / all.length;
  const { context } = view;
  context.font = inside ? 'bold 9px sans-serif' : '12px sans-serif';
  context.textAlign = 'center';
  context.textBaseline = 'middle';
  const down = inside ? 0.5 : shape.form === kForms.polygon ? 0 : 14;
  context.lineWidth = 3;
  context.strokeStyle = colours.floor;
  if (!inside) context.strokeText(shape.label[language], x, y + down);
  context.fillStyle = inside ? kInk : colours.line;
  context.fillText(shape.label[language], x, y + down);
}

/** Lines lie below the ways of robots, everything else above them. */
export function drawShapes(
  view: View,
  shapes: PlacedShape[],
  lines: boolean,
  language: Language,
  colours: WorldColours,
): void {
  const some = shapes.filter(({ shape }) => (shape.form === kForms.polyline) === lines);
  for (const placed of some) drawShape(view, placed, colours);
  for (const placed of some) drawLabel(view, placed, language, colours);
}
