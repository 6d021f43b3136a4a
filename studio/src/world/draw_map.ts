import type { MapState } from '../state/map_track';
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

/** One cell in the chosen layer. "label" shows what is believed: 0.5 free, 1 occupied. */
export function cellColour(layer: string, value: number): Dot {
  if (value === 0 && layer !== 'risk') return kNothing;
  if (layer !== 'label') return [...viridis(value / 255), 215];
  return value > 191 ? [52, 60, 70, 225] : [150, 200, 190, 190];
}

/** Paints a learned map by one picture, a dot a cell, made anew only when the map or the layer changed. */
export class MapPainter {
  private readonly image = typeof OffscreenCanvas === 'undefined' ? null : new OffscreenCanvas(1, 1);
  private painted = '';

  draw(view: View, map: MapState, layers: string[], layer: string, colours: WorldColours): void {
    const index = layers.indexOf(layer);
    if (index < 0 || !this.image) return;
    const key = `${layer} ${map.version} ${map.columns} ${map.rows} ${map.origin}`;
    if (key !== this.painted) {
      this.painted = key;
      this.paint(map, index, layer, layers.indexOf('label'));
    }
    const { context } = view;
    context.imageSmoothingEnabled = false;
    const [width, height] = [map.columns * map.cell_m * view.scale, map.rows * map.cell_m * view.scale];
    context.drawImage(this.image, view.x(map.origin[0]), view.y(map.origin[1]) - height, width, height);
    this.marks(view, map, layers.indexOf('inhibited'), colours);
  }

  private paint(map: MapState, index: number, layer: string, label: number): void {
    if (!this.image) return;
    this.image.width = map.columns;
    this.image.height = map.rows;
    const context = this.image.getContext('2d');
    if (!context) return;
    const picture = context.createImageData(map.columns, map.rows);
    for (let row = 0; row < map.rows; row += 1) {
      for (let column = 0; column < map.columns; column += 1) {
        const cell = (row * map.columns + column) * map.layers;
        const known = label < 0 || map.values[cell + label] > 0;
        const dot = known ? cellColour(layer, map.values[cell + index]) : kNothing;
        picture.data.set(dot, ((map.rows - 1 - row) * map.columns + column) * 4);
      }
    }
    context.putImageData(picture, 0, 0);
  }

  /** Inhibited cells bear a cross in every layer. */
  private marks(view: View, map: MapState, inhibited: number, colours: WorldColours): void {
    const size = Math.min(7, (map.cell_m * view.scale) / 3);
    if (inhibited < 0 || size < 1.5) return;
    view.context.beginPath();
    for (let i = 0; i < map.columns * map.rows; i += 1) {
      if (map.values[i * map.layers + inhibited] === 0) continue;
      const x = view.x(map.origin[0] + ((i % map.columns) + 0.5) * map.cell_m);
      const y = view.y(map.origin[1] + (Math.floor(i / map.columns) + 0.5) * map.cell_m);
      view.context.moveTo(x - size, y - size);
      view.context.lineTo(x + size, y + size);
      view.context.moveTo(x - size, y + size);
      view.context.lineTo(x + size, y - size);
    }
    view.stroke('#ffffff', 4);
    view.stroke(colours.contact, 2);
  }
}
