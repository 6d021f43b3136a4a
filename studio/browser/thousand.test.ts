import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import type { CDPSession, Page } from 'playwright-core';
import { afterAll, beforeAll, expect, test } from 'vitest';
import { find } from './hands';
import { open, Studio } from './studio';
import { framesWhile, thousand } from './thousand';
import { timeKey, watchPage } from './watch_page';

// Limits here are those of a busy machine; `./dev bench studio` measures.
let studio: Studio;
let page: Page;
let session: CDPSession;
beforeAll(async () => {
  studio = await Studio.start();
  writeFileSync(join(studio.folder, 'nimrod', 'thousand.toml'), thousand());
  page = await studio.page();
  session = await page.context().newCDPSession(page);
  await session.send('Performance.enable', { timeDomain: 'threadTicks' });
});
afterAll(() => studio?.stop());

test('a drawing of a thousand components opens in a moment', async () => {
  const before = performance.now();
  await open(page, 'nimrod/thousand.toml');
  const took_ms = performance.now() - before;
  console.log(`1,000 components opened in ${took_ms.toFixed(0)} ms`);
  expect(took_ms).toBeLessThan(6000);
});

test('it is panned and a box is dragged fluently', async () => {
  await page.mouse.move(420, 300);
  await page.mouse.down();
  const pan = await framesWhile(page, (step) => page.mouse.move(420 + 3 * step, 300 + step));
  await page.mouse.up();
  await find(page, 'c250');
  await page.waitForTimeout(300);
  const at = await page.locator('.box[data-component="c250"] .box-head').boundingBox();
  if (!at) throw new Error('c250 is not in sight');
  await page.mouse.move(at.x + 40, at.y + 10);
  await page.mouse.down();
  const drag = await framesWhile(page, (step) => page.mouse.move(at.x + 40 + step, at.y + 10 + step));
  await page.mouse.up();
  console.log(`1,000 components: panned at ${pan.toFixed(0)} and dragged at ${drag.toFixed(0)} frames a second`);
  expect(Math.min(pan, drag)).toBeGreaterThan(10);
});

// tests/document.test.ts undoes two hundred steps; here it is what the page has to do for one.
test('steps are undone at once', async () => {
  await page.locator('.head').getByText('not saved').waitFor();
  await page.locator('.canvas').focus();
  await watchPage(page);
  const steps = () => page.evaluate(() => document.querySelectorAll('.history li').length);
  await page.locator('.left .tabs button').nth(2).click();
  await expect.poll(steps).toBe(2);
  await page.locator('.canvas').focus();
  for (let i = 0; i < 10; i += 1) {
    for (const key of ['ArrowLeft', 'Alt+ArrowDown', 'ArrowRight', 'Alt+ArrowDown']) await page.keyboard.press(key);
    await expect.poll(steps, { timeout: 20_000 }).toBe(4 + 2 * i);
  }
  const work_ms: number[] = [];
  for (let i = 0; i < 20; i += 1) work_ms.push((await timeKey(page, session, 'Control+z')).busy_ms);
  const median = [...work_ms].sort((a, b) => a - b)[work_ms.length >> 1];
  console.log(`undo: ${work_ms.length} steps, half of them within ${median.toFixed(0)} ms of the main thread's work`);
  expect(median).toBeLessThan(150);
});
