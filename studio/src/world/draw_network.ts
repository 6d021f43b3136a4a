import { roleLook, type ShownNetwork } from '../api/exhibits';
import type { FieldState } from '../state/field_track';
import { cellColour } from './draw_field';
import { axisName, line, type Margins, type Sheet, short, write } from './sheet';

export const kNetworkHeight = 260;
export const kNetworkMargins: Margins = [80, 30, 80, 46];
export const kTableHeight = 200;
export const kTableMargins: Margins = [86, 28, 10, 44];
const kNode = 11;

type Place = [number, number];

function drawEdge(sheet: Sheet, [ax, ay]: Place, [bx, by]: Place, role: string, width: number): void {
  const way = Math.hypot(bx - ax, by - ay);
  if (way < 2 * kNode + 2) return;
  const [ux, uy] = [(bx - ax) / way, (by - ay) / way];
  const [tx, ty] = [bx - 14 * ux, by - 14 * uy];
  const colour = sheet.colours.roles[role];
  const from: Place = [ax + kNode * ux, ay + kNode * uy];
  line(sheet, [from, [tx - 6 * ux, ty - 6 * uy]], colour, width, roleLook(role).dash);
  const { context } = sheet;
  context.beginPath();
  for (const [forth, aside] of [
    [0, 0],
    [-11, 5],
    [-11, -5],
  ]) {
    context.lineTo(tx + forth * ux - aside * uy, ty + forth * uy + aside * ux);
  }
  context.fillStyle = colour;
  context.fill();
}

/** Nodes in their places, edges as wide as their weights. */
export function drawNetwork(sheet: Sheet, { nodes, edges }: ShownNetwork): void {
  const { area, colours, context, language } = sheet;
  const span = (values: number[]): Place => [Math.min(...values), Math.max(...values)];
  const [x0, x1] = span(nodes.map((node) => node.x));
  const [y0, y1] = span(nodes.map((node) => node.y));
  const places = nodes.map(
    (node): Place => [
      area.left + area.width * (x1 > x0 ? (node.x - x0) / (x1 - x0) : 0.5),
      area.top + area.height * (y1 > y0 ? 1 - (node.y - y0) / (y1 - y0) : 0.5),
    ],
  );
  const heaviest = Math.max(1e-12, ...edges.map((edge) => Math.abs(edge.weight)));
  for (const edge of edges) {
    const width = 0.8 + (3.2 * Math.abs(edge.weight)) / heaviest;
    drawEdge(sheet, places[edge.from], places[edge.to], edge.role, width);
  }
  nodes.forEach((node, i) => {
    const [x, y] = places[i];
    context.beginPath();
    context.arc(x, y, kNode, 0, 2 * Math.PI);
    context.fillStyle = node.role === 'plain' ? colours.free : colours.roles[node.role];
    context.fill();
    context.strokeStyle = colours.line;
    context.lineWidth = 1.4;
    context.stroke();
    write(sheet, node.title[language], x, y + 22, 'center', 150);
  });
}

function drawLayer(sheet: Sheet, field: FieldState, index: number, x0: number, width: number): void {
  const { area, colours, context, language } = sheet;
  const { columns, rows, layers, values, words } = field;
  const layer = words.layers[index];
  const [wide, high] = [width / columns, area.height / rows];
  const bottom = area.top + area.height;
  for (let cell = 0; cell < columns * rows; cell += 1) {
    const [r, g, b, a] = cellColour(layer, values[cell * layers + index], colours.roles);
    context.fillStyle = `rgba(${r}, ${g}, ${b}, ${a / 255})`;
    const [column, row] = [cell % columns, Math.floor(cell / columns)];
    context.fillRect(x0 + column * wide, bottom - (row + 1) * high, wide + 0.5, high + 0.5);
  }
  const unit = layer.unit ? ` [${layer.unit}]` : '';
  const range = layer.classes.length > 0 ? '' : ` ${short(layer.low)} – ${short(layer.high)}`;
  write(sheet, `${layer.title[language]}${unit}${range}`, x0, area.top - 12, 'left', width);
  words.across?.ticks.forEach((tick, i) => {
    write(sheet, tick[language], x0 + (i + 0.5) * wide, bottom + 12, 'center', wide - 2);
  });
  if (words.across) write(sheet, axisName(words.across, language), x0 + width / 2, bottom + 32, 'center', width);
}

/** A field with axes of its own: each layer beside the others, with its name and scale. */
export function drawTable(sheet: Sheet, field: FieldState): void {
  const { area, language } = sheet;
  const { words, rows } = field;
  const pitch = area.width / words.layers.length;
  words.layers.forEach((_, index) => {
    drawLayer(sheet, field, index, area.left + index * pitch, pitch - 14);
  });
  words.up?.ticks.forEach((tick, i) => {
    const y = area.top + area.height - ((i + 0.5) * area.height) / rows;
    write(sheet, tick[language], area.left - 6, y, 'right', 78);
  });
  if (words.up) write(sheet, axisName(words.up, language), area.left - 80, area.top - 12, 'left', 76);
}
