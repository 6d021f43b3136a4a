import { kUnknown, roleLook, type ShownClass, type ShownLayer } from '../api/exhibits';
import type { FieldState } from '../state/field_track';
import type { Place } from '../state/frames';
import { drawCross } from './draw_shapes';
import type { View, WorldColours } from './view';

const kViridis = [
  [68, 1, 84],
  [72, 37, 118],
  [65, 68, 135],
  [53, 96, 141],
  [42, 120, 142],
  [33, 144, 140],
  [34, 168, 132],
  [67, 191, 113],
  [122, 209, 81],
  [187, 223, 39],
  [253, 231, 37],
];

export function viridis(value: number): [number, number, number] {
  const place = Math.min(1, Math.max(0, value)) * (kViridis.length - 1);
  const below = Math.min(kViridis.length - 2, Math.floor(place));
  const [r, g, b] = kViridis[below].map((from, i) =>
    Math.round(from + (kViridis[below + 1][i] - from) * (place - below)),
  );
  return [r, g, b];
}

type Dot = [number, number, number, number];
const kNothing: Dot = [0, 0, 0, 0];

/** The class whose byte is nearest; none for a scale. */
export function classOf(layer: ShownLayer, byte: number): ShownClass | undefined {
  let best: ShownClass | undefined;
  for (const one of layer.classes) if (!best || Math.abs(one.byte - byte) < Math.abs(best.byte - byte)) best = one;
  return best;
}

function channels(colour: string): [number, number, number] {
  const part = (at: number) => Number.parseInt(colour.slice(at, at + 2), 16);
  return [part(1), part(3), part(5)];
}

/** One cell of a layer: a class in its role's colour, else the place on the scale. */
export function cellColour(layer: ShownLayer, byte: number, roles: Record<string, string>): Dot {
  if (byte === kUnknown) return kNothing;
  const one = classOf(layer, byte);
  return one ? [...channels(roles[one.role]), 205] : [...viridis(byte / 254), 215];
}

/** What marks a cell of a class besides its colour, in a box of twice `size` about a point of the canvas. */
function drawSign(view: View, sign: string, [x, y]: [number, number], size: number, colour: string): void {
  const { context } = view;
  if (sign === 'cross') {
    drawCross(context, x, y, size);
    view.stroke('#ffffff', 4);
    view.stroke(colour, 2);
    return;
  }
  context.beginPath();
  if (sign === 'hatch') {
    context.moveTo(x - size, y + size);
    context.lineTo(x + size, y - size);
    view.stroke('#ffffff', 1.4);
  } else if (sign === 'dot') {
    context.arc(x, y, Math.max(1.5, size / 2.5), 0, 2 * Math.PI);
    view.fill('#ffffff');
  }
}

/** Paints one layer of a field by one picture, a dot a cell, made anew only when the field or the layer changed. */
export class FieldPainter {
  private readonly image = typeof OffscreenCanvas === 'undefined' ? null : new OffscreenCanvas(1, 1);
  private painted = '';

  draw(view: View, field: FieldState, place: Place, layer: string, colours: WorldColours): void {
    const index = field.words.layers.findIndex((one) => one.name === layer);
    if (index < 0 || !this.image) return;
    const key = `${layer} ${field.version} ${field.columns} ${field.rows} ${field.origin} ${colours.floor}`;
    if (key !== this.painted) {
      this.painted = key;
      this.paint(field, index, colours);
    }
    const { context } = view;
    const [wide, high] = field.words.cell.map((side) => side * view.scale);
    const [left, below] = [field.origin[0] * view.scale, -field.origin[1] * view.scale];
    context.save();
    context.translate(view.x(place.x), view.y(place.y));
    context.rotate(-place.yaw);
    context.imageSmoothingEnabled = false;
    context.drawImage(this.image, left, below - field.rows * high, field.columns * wide, field.rows * high);
    const size = Math.min(7, Math.min(wide, high) / 3);
    if (size >= 1.5) {
      this.signs(view, field, (c, r) => [left + (c + 0.5) * wide, below - (r + 0.5) * high], size, colours);
    }
    context.restore();
  }

  private paint(field: FieldState, index: number, colours: WorldColours): void {
    if (!this.image) return;
    this.image.width = field.columns;
    this.image.height = field.rows;
    const context = this.image.getContext('2d');
    if (!context) return;
    const picture = context.createImageData(field.columns, field.rows);
    const layer = field.words.layers[index];
    for (let row = 0; row < field.rows; row += 1) {
      for (let column = 0; column < field.columns; column += 1) {
        const byte = field.values[(row * field.columns + column) * field.layers + index];
        const dot = ((field.rows - 1 - row) * field.columns + column) * 4;
        picture.data.set(cellColour(layer, byte, colours.roles), dot);
      }
    }
    context.putImageData(picture, 0, 0);
  }

  /** Of every layer of classes, whichever is painted; a cross covers a dot. */
  private signs(
    view: View,
    field: FieldState,
    place: (column: number, row: number) => [number, number],
    size: number,
    colours: WorldColours,
  ): void {
    const named = field.words.layers.map((layer, i) => ({ layer, i })).filter(({ layer }) => layer.classes.length > 0);
    for (let cell = 0; cell < field.columns * field.rows; cell += 1) {
      const roles: string[] = [];
      for (const { layer, i } of named) {
        const byte = field.values[cell * field.layers + i];
        const one = byte === kUnknown ? undefined : classOf(layer, byte);
        if (one && roleLook(one.role).sign !== 'none') roles.push(one.role);
      }
      if (roles.length === 0) continue;
      const crossed = roles.some((role) => roleLook(role).sign === 'cross');
      const at = place(cell % field.columns, Math.floor(cell / field.columns));
      for (const role of roles) {
        const { sign } = roleLook(role);
        if (!crossed || sign !== 'dot') drawSign(view, sign, at, size, colours.roles[role]);
      }
    }
  }
}
