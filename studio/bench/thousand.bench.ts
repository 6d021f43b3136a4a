// A drawing of a thousand components: opening, panning, dragging; two hundred edits, undone and done again.
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import type { CDPSession, Page } from 'playwright-core';
import { afterAll, beforeAll, test } from 'vitest';
import { find } from '../browser/hands';
import { open, Studio } from '../browser/studio';
import { framesWhile, thousand } from '../browser/thousand';
import { type Taken, timeKey, watchPage } from '../browser/watch_page';
import { favour } from './processes';
import { atLeast, atMost, printRows, quantile, row } from './rows';

let studio: Studio;
let page: Page;
let session: CDPSession;

beforeAll(async () => {
  studio = await Studio.start();
  writeFileSync(join(studio.folder, 'nimrod', 'thousand.toml'), thousand());
  page = await studio.page();
  session = await page.context().newCDPSession(page);
  await session.send('Performance.enable', { timeDomain: 'threadTicks' });
  favour([...(await studio.browserPids()), studio.pid]);
});
afterAll(async () => {
  printRows();
  await studio?.stop();
});

const kStepBar_ms = 50;
const kEditBar_ms = 100;
const kOpenBar_ms = 1500;
const kFramesBar = 40;

function rowsOf(name: string, taken: Taken[], bar_ms: number): void {
  const shown = taken.map((one) => one.shown_ms);
  atMost(`${name}, key to paint: median of ${taken.length}`, quantile(shown, 0.5), bar_ms, 'ms');
  atMost(`${name}, key to paint: 95 %`, quantile(shown, 0.95), bar_ms, 'ms');
  atMost(`${name}, key to paint: worst`, Math.max(...shown), bar_ms, 'ms');
  const busy = taken.map((one) => one.busy_ms);
  row(
    `${name}, work of the main thread: median, 95 %, worst`,
    `${quantile(busy, 0.5).toFixed(0)}, ${quantile(busy, 0.95).toFixed(0)}, ${Math.max(...busy).toFixed(0)} ms`,
  );
}

test('opens, pans and drags', async () => {
  favour([...(await studio.browserPids()), studio.pid]);
  const before = performance.now();
  await open(page, 'nimrod/thousand.toml');
  atMost('1,000 components open', performance.now() - before, kOpenBar_ms, 'ms');
  await page.mouse.move(420, 300);
  await page.mouse.down();
  atLeast(
    'pan',
    await framesWhile(page, (step) => page.mouse.move(420 + 3 * step, 300 + step)),
    kFramesBar,
    'frames/s',
  );
  await page.mouse.up();
  await find(page, 'c250');
  await page.waitForTimeout(300);
  const at = await page.locator('.box[data-component="c250"] .box-head').boundingBox();
  if (!at) throw new Error('c250 is not in sight');
  await page.mouse.move(at.x + 40, at.y + 10);
  await page.mouse.down();
  const drag = await framesWhile(page, (step) => page.mouse.move(at.x + 40 + step, at.y + 10 + step));
  await page.mouse.up();
  atLeast('drag', drag, kFramesBar, 'frames/s');
});

const edits = new Map<string, Taken[]>();

async function timed(sort: string, key: string): Promise<void> {
  edits.set(sort, [...(edits.get(sort) ?? []), await timeKey(page, session, key)]);
}

async function onDrawing(): Promise<void> {
  await page.locator('.canvas').focus();
}

/** Six edits of six sorts, each by the key that ends it. */
async function editAround(i: number): Promise<void> {
  await find(page, `c${i}`);
  await onDrawing();
  await timed('move', 'Alt+ArrowDown');
  const field = page
    .locator('.right')
    .getByLabel(/^readings/)
    .first();
  await field.focus();
  await page.keyboard.press('Control+A');
  await page.keyboard.type(`${1 + (i % 5)}`);
  await timed('parameter', 'Enter');
  await onDrawing();
  await page.keyboard.press('F2');
  await page.getByRole('dialog').waitFor();
  await page.keyboard.press('Control+A');
  await page.keyboard.type(`n${i}`);
  await timed('rename', 'Enter');
  await find(page, `s${i}`);
  await onDrawing();
  await timed('add', 'Control+d');
  await onDrawing();
  await page.keyboard.press('c');
  await page.getByRole('dialog').waitFor();
  await page.keyboard.type(`n${i}.raw_range`);
  await page.getByRole('option', { name: `n${i}.raw_range`, exact: true }).waitFor();
  await timed('wire', 'Enter');
  await onDrawing();
  await timed('delete', 'Delete');
}

test('is edited two hundred times', async () => {
  await watchPage(page);
  favour([...(await studio.browserPids()), studio.pid]);
  for (let i = 0; i < 34; i += 1) await editAround(1 + 14 * i);
  for (const [sort, taken] of edits) rowsOf(`edit: ${sort}`, taken, kEditBar_ms);
}, 900_000);

async function timeSteps(key: string, count: number): Promise<Taken[]> {
  await onDrawing();
  const taken: Taken[] = [];
  for (let i = 0; i < count; i += 1) taken.push(await timeKey(page, session, key));
  return taken;
}

test('undoes two hundred steps and does them again, all in sight and close by', async () => {
  // Of what a parameter's step changes nothing may be in sight; the history tells of every one.
  await page.locator('.left .tabs button').nth(2).click();
  await onDrawing();
  await page.keyboard.press('f');
  await page.waitForTimeout(2000);
  rowsOf('undo, all in sight', await timeSteps('Control+z', 200), kStepBar_ms);
  rowsOf('redo, all in sight', await timeSteps('Control+Shift+Z', 200), kStepBar_ms);
  await find(page, 's300');
  await page.waitForTimeout(1000);
  rowsOf('undo, close by', await timeSteps('Control+z', 200), kStepBar_ms);
}, 900_000);
