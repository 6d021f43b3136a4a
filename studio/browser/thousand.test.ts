import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { afterAll, beforeAll, expect, test } from 'vitest';
import { open, Studio } from './studio';

let studio: Studio;
let page: Page;
beforeAll(async () => {
  studio = await Studio.start();
  let toml = 'format = 1\nname = "Thousand"\nrobot = "robot.toml"\n';
  for (let i = 0; i < 500; i += 1) {
    toml += `\n[[sensation]]\nid = "s${i}"\nchannel = "sonar_left.range"\n`;
    toml += `\n[[sensing]]\nid = "c${i}"\nkind = "SonarConditioner"\nin.raw_range = "s${i}"\n`;
  }
  writeFileSync(join(studio.folder, 'nimrod', 'thousand.toml'), toml);
  page = await studio.page();
});
afterAll(() => studio?.stop());

/** Frames a second while something is moved about by the mouse. */
async function framesWhile(move: (step: number) => Promise<void>): Promise<number> {
  await page.evaluate(() => {
    const counter = { frames: 0, since: performance.now() };
    (window as unknown as { counter: typeof counter }).counter = counter;
    const count = () => {
      counter.frames += 1;
      requestAnimationFrame(count);
    };
    requestAnimationFrame(count);
  });
  for (let step = 0; step < 60; step += 1) await move(step);
  return page.evaluate(() => {
    const { counter } = window as unknown as { counter: { frames: number; since: number } };
    return (1000 * counter.frames) / (performance.now() - counter.since);
  });
}

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
  const pan = await framesWhile((step) => page.mouse.move(420 + 3 * step, 300 + step));
  await page.mouse.up();
  await page.keyboard.press('Control+f');
  await page.keyboard.type('c250');
  await page.keyboard.press('Enter');
  await page.waitForTimeout(300);
  const at = await page.locator('.box[data-component="c250"] .box-head').boundingBox();
  if (!at) throw new Error('c250 is not in sight');
  await page.mouse.move(at.x + 40, at.y + 10);
  await page.mouse.down();
  const drag = await framesWhile((step) => page.mouse.move(at.x + 40 + step, at.y + 10 + step));
  await page.mouse.up();
  console.log(`1,000 components: panned at ${pan.toFixed(0)} and dragged at ${drag.toFixed(0)} frames a second`);
  expect(Math.min(pan, drag)).toBeGreaterThan(5);
});

// tests/document.test.ts undoes two hundred steps; here it is how long the page takes for one.
test('steps are undone at once', async () => {
  await page.locator('.head').getByText('not saved').waitFor();
  await page.locator('.canvas').focus();
  for (let i = 0; i < 20; i += 1) {
    for (const key of ['ArrowLeft', 'Alt+ArrowDown', 'ArrowRight', 'Alt+ArrowDown']) await page.keyboard.press(key);
  }
  await page.waitForTimeout(9000);
  const took_ms = await page.evaluate(async () => {
    const button = document.querySelectorAll<HTMLButtonElement>('.head > button');
    const times: number[] = [];
    while (!button[0].disabled && times.length < 200) {
      const before = performance.now();
      button[0].click();
      // Shown is what the second frame after it draws.
      await new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve)));
      times.push(performance.now() - before);
    }
    return times;
  });
  const median = [...took_ms].sort((a, b) => a - b)[took_ms.length >> 1];
  console.log(`undo: ${took_ms.length} steps, half of them within ${median.toFixed(0)} ms`);
  expect(took_ms.length).toBeGreaterThan(20);
  expect(median).toBeLessThan(250);
});
