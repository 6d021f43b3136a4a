import { api } from '../api/client';
import type { Operation } from '../api/types';
import { current, edit, place, select, useDocument } from '../state/document';
import { fit, places, selectedEdges } from './canvas_handle';
import { heightOf, kWidth, portsOf } from './geometry';
import { arrange, boxesOf, type Point } from './placing';

const kOffset: Point = [30, 30];
const kAsk_ms = 400;
let clipboard = '';
let copying: Promise<void> = Promise.resolve();

function chosen(): string[] {
  return useDocument.getState().selection;
}

export function copy(): Promise<void> {
  copying = api.copy(place(), chosen()).then(async ({ toml }) => {
    clipboard = toml;
    await navigator.clipboard?.writeText(toml).catch(() => undefined);
  });
  return copying;
}

export async function cut(): Promise<void> {
  await copy();
  await remove();
}

/** What another program put there counts, if the browser lets us read it soon; else what was copied here. */
async function clipboardText(): Promise<string> {
  await copying.catch(() => undefined);
  const asked = navigator.clipboard?.readText?.().catch(() => '');
  const late = new Promise<string>((resolve) => setTimeout(() => resolve(''), kAsk_ms));
  const read = await Promise.race([asked, late]);
  return read?.includes('[[') ? read : clipboard;
}

async function pasteText(toml: string): Promise<void> {
  if (toml === '') return;
  const before = new Set(current()?.model.components.map((component) => component.id));
  const ids = await edit([{ op: 'paste', toml, offset: kOffset }]);
  select(ids.filter((id) => !before.has(id)));
}

export async function paste(): Promise<void> {
  await pasteText(await clipboardText());
}

export async function duplicate(): Promise<void> {
  await pasteText((await api.copy(place(), chosen())).toml);
}

/** Chosen wires, else chosen components with their wires. */
export async function remove(): Promise<void> {
  const wires = selectedEdges().map(
    (edge): Operation => ({
      op: 'disconnect',
      id: edge.target,
      port: edge.data?.port ?? '',
      from: edge.data?.wire.text ?? '',
    }),
  );
  const ids = chosen();
  const own = wires.filter((wire) => wire.op === 'disconnect' && !ids.includes(wire.id));
  await edit(ids.length > 0 ? [...own, { op: 'remove', ids }] : wires);
}

function move(positions: Map<string, Point>): Promise<unknown> {
  return edit([{ op: 'move', positions: Object.fromEntries(positions) }]);
}

export async function align(edge: 'left' | 'top'): Promise<void> {
  const now = places(chosen());
  const axis = edge === 'left' ? 0 : 1;
  const line = Math.min(...[...now.values()].map((at) => at[axis]));
  await move(new Map([...now].map(([id, at]) => [id, axis === 0 ? [line, at[1]] : [at[0], line]])));
}

/** The same gap below each of the chosen. */
export async function distribute(): Promise<void> {
  const now = [...places(chosen())].sort(([, a], [, b]) => a[1] - b[1]);
  if (now.length < 3) return;
  const [top, bottom] = [now[0][1][1], now[now.length - 1][1][1]];
  const gap = (bottom - top) / (now.length - 1);
  await move(new Map(now.map(([id, [x]], i) => [id, [x, Math.round(top + i * gap)]])));
}

/** Every box to a place of its own, left to right along the wires. */
export async function tidy(): Promise<void> {
  const model = current()?.model;
  if (!model) return;
  const wired = new Set<string>();
  const boxes = boxesOf(model.components, (one) => heightOf(portsOf(one, wired, false)) + kWidth / 10);
  await move(arrange(boxes));
  requestAnimationFrame(fit);
}
