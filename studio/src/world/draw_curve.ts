import { roleLook, type ShownBars, type ShownCurve } from '../api/exhibits';
import { axisName, line, type Margins, type Sheet, short, write, writeUpright } from './sheet';

export const kCurveHeight = 230;
export const kCurveMargins: Margins = [64, 10, 150, 42];
export const kBarMargins: Margins = [150, 6, 60, 34];
const kBar = 24;
/** For lines that no role tells apart. */
const kDashes = [[], [7, 3], [2, 2.5], [9, 3, 2, 3], [4, 2], [12, 4]];

export const barsHeight = (count: number) => 46 + kBar * Math.max(1, count);

function lineLook(sheet: Sheet, lines: ShownCurve['lines'], i: number): [string, number[]] {
  const { role } = lines[i];
  const alone = role !== 'plain' && lines.filter((one) => one.role === role).length === 1;
  return [sheet.colours.roles[role], alone ? roleLook(role).dash : kDashes[i % kDashes.length]];
}

function extentOf(lines: ShownCurve['lines']): [number, number, number, number] {
  const xs = lines.flatMap(({ xy }) => xy.filter((_, i) => i % 2 === 0));
  const ys = lines.flatMap(({ xy }) => xy.filter((_, i) => i % 2 === 1));
  if (xs.length === 0) return [0, 0, 1, 1];
  const least = (all: number[]) => all.reduce((a, b) => Math.min(a, b));
  const most = (all: number[]) => all.reduce((a, b) => Math.max(a, b));
  const [x0, x1, y0, y1] = [least(xs), most(xs), least(ys), most(ys)];
  const pad = y1 > y0 ? 0.06 * (y1 - y0) : 0.5;
  return [x0, y0 - pad, x1 > x0 ? x1 : x0 + 1, y1 + pad];
}

/** Lines with their words beside them, and the place that the curve's signal marks. */
export function drawCurve(sheet: Sheet, curve: ShownCurve, cursor: number): void {
  const { area, colours, language, width, height } = sheet;
  const [x0, y0, x1, y1] = extentOf(curve.lines);
  const x = (value: number) => area.left + (area.width * (value - x0)) / (x1 - x0);
  const y = (value: number) => area.top + area.height * (1 - (value - y0) / (y1 - y0));
  curve.lines.forEach((one, i) => {
    const points: [number, number][] = [];
    for (let k = 0; k + 1 < one.xy.length; k += 2) points.push([x(one.xy[k]), y(one.xy[k + 1])]);
    const [colour, dash] = lineLook(sheet, curve.lines, i);
    line(sheet, points, colour, 2, dash);
    const row = area.top + 10 + 18 * i;
    line(
      sheet,
      [
        [width - 140, row],
        [width - 112, row],
      ],
      colour,
      2,
      dash,
    );
    write(sheet, one.title[language], width - 106, row, 'left', 104);
  });
  if (cursor >= x0 && cursor <= x1) {
    const mark: [number, number][] = [
      [x(cursor), area.top],
      [x(cursor), area.top + area.height],
    ];
    line(sheet, mark, colours.roles.danger, 1.6, [4, 3]);
    write(sheet, `${curve.cursor} ${short(cursor)}`, width - 140, area.top + area.height - 8, 'left', 138);
  }
  sheet.context.strokeStyle = colours.line;
  sheet.context.lineWidth = 1;
  sheet.context.strokeRect(area.left, area.top, area.width, area.height);
  for (const part of [0, 0.5, 1]) {
    write(sheet, short(x0 + part * (x1 - x0)), area.left + part * area.width, area.top + area.height + 12);
    write(sheet, short(y0 + part * (y1 - y0)), area.left - 6, y(y0 + part * (y1 - y0)), 'right', 56);
  }
  write(sheet, axisName(curve.across, language), area.left + area.width / 2, height - 10);
  writeUpright(sheet, axisName(curve.up, language), 10, area.top + area.height / 2, area.height);
}

export function drawBars(sheet: Sheet, { bars, up }: ShownBars): void {
  const { area, colours, context, language } = sheet;
  const values = bars.map((bar) => bar.value);
  const [low, high] = [Math.min(0, ...values), Math.max(0, ...values)];
  const shift = low < 0 ? 46 : 0;
  const x = (value: number) => area.left + shift + ((area.width - shift) * (value - low)) / (high - low || 1);
  bars.forEach((bar, i) => {
    const top = area.top + kBar * i;
    write(sheet, bar.title[language], area.left - 8, top + 12, 'right', 136);
    context.fillStyle = colours.roles[bar.role];
    context.fillRect(Math.min(x(0), x(bar.value)), top + 4, Math.max(1, Math.abs(x(bar.value) - x(0))), 16);
    const left = bar.value < 0;
    write(sheet, short(bar.value), x(bar.value) + (left ? -5 : 5), top + 12, left ? 'right' : 'left');
  });
  const bottom = area.top + kBar * bars.length;
  line(
    sheet,
    [
      [x(0), area.top],
      [x(0), bottom],
    ],
    colours.line,
    1,
  );
  write(sheet, axisName(up, language), area.left + area.width / 2, bottom + 18);
}
