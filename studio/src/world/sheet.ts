import type { ShownAxis } from '../api/exhibits';
import type { Language } from '../api/types';
import type { WorldColours } from './view';

/** Where on a canvas a panel draws, and with what. */
export interface Sheet {
  context: CanvasRenderingContext2D;
  width: number;
  height: number;
  /** Inside the margins for words. */
  area: { left: number; top: number; width: number; height: number };
  language: Language;
  colours: WorldColours;
}

export type Margins = readonly [left: number, top: number, right: number, bottom: number];

/** Makes the canvas as high as the panel needs, and empty; null where there is nothing to draw on. */
export function sheetOn(
  canvas: HTMLCanvasElement,
  height: number,
  [left, top, right, bottom]: Margins,
  language: Language,
  colours: WorldColours,
): Sheet | null {
  canvas.style.height = `${height}px`;
  const ratio = window.devicePixelRatio || 1;
  const width = canvas.clientWidth;
  const context = canvas.getContext('2d');
  if (!context || width === 0) return null;
  const [w, h] = [Math.round(width * ratio), Math.round(height * ratio)];
  if (canvas.width !== w || canvas.height !== h) Object.assign(canvas, { width: w, height: h });
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.clearRect(0, 0, width, height);
  context.font = '12px sans-serif';
  context.textBaseline = 'middle';
  const area = { left, top, width: width - left - right, height: height - top - bottom };
  return { context, width, height, area, language, colours };
}

export function write(
  { context, colours }: Sheet,
  words: string,
  x: number,
  y: number,
  align: CanvasTextAlign = 'center',
  most = 400,
): void {
  context.fillStyle = colours.line;
  context.textAlign = align;
  context.fillText(words, x, y, most);
}

export function writeUpright(sheet: Sheet, words: string, x: number, y: number, most: number): void {
  sheet.context.save();
  sheet.context.translate(x, y);
  sheet.context.rotate(-Math.PI / 2);
  write(sheet, words, 0, 0, 'center', most);
  sheet.context.restore();
}

export function line(
  { context }: Sheet,
  points: readonly (readonly [number, number])[],
  colour: string,
  width: number,
  dash: readonly number[] = [],
): void {
  context.beginPath();
  for (const [x, y] of points) context.lineTo(x, y);
  context.strokeStyle = colour;
  context.lineWidth = width;
  context.setLineDash([...dash]);
  context.stroke();
  context.setLineDash([]);
}

export function axisName(axis: ShownAxis, language: Language): string {
  return axis.unit ? `${axis.title[language]} [${axis.unit}]` : axis.title[language];
}

export function short(value: number): string {
  return `${Number(value.toPrecision(3))}`;
}
