import type { Page } from 'playwright-core';
import { afterAll, beforeAll, expect, test } from 'vitest';
import { kLooks, open, Studio, shot } from './studio';

let studio: Studio;
let page: Page;
beforeAll(async () => {
  studio = await Studio.start();
  page = await studio.page();
  await open(page, 'pathfinder/controller.toml');
});
afterAll(() => studio?.stop());

const state = () => page.locator('.run-now b').innerText();
const bar = (name: string) => page.locator('.run-bar').getByRole('button', { name, exact: true });
const shownTime = async () => Number.parseFloat(await page.locator('.time-now').innerText());

test('the simulation is configured: experiment, seed, connection tested, the robot describes itself', async () => {
  await bar('Configure…').click();
  const dialog = page.getByRole('dialog');
  await dialog.getByLabel('Experiment').selectOption('pathfinder/experiment.toml');
  await dialog.getByLabel('Seed').fill('3');
  await dialog.getByRole('button', { name: 'Test connection' }).click();
  await dialog.getByText('the simulation is ready').waitFor();
  await dialog.getByText('What the robot says of itself').waitFor();
  await dialog.getByLabel('Wait before the first tick').check();
  await shot(page, 'configure');
  await dialog.getByRole('button', { name: 'Done' }).click();
});

test('a run waits armed, goes a tick at a time, runs, pauses, and shows its values on the wires', async () => {
  await page.locator('.canvas').focus();
  await page.keyboard.press('F5');
  await expect.poll(state).toMatch(/armed|paused/);
  await bar('One tick').click();
  await expect.poll(() => page.locator('.wire-value:visible').count()).toBeGreaterThan(5);
  await page.locator('.run-bar select').selectOption('10');
  await bar('Pause or go on').click();
  await expect.poll(state).toBe('running');
  await expect.poll(shownTime, { timeout: 20_000 }).toBeGreaterThan(5);
  await page.locator('.wire-value:visible').first().hover();
  await page.locator('.sparkline').waitFor();
  await shot(page, 'running');
  await bar('Pause or go on').click();
  await expect.poll(state).toBe('paused');
});

test('the view is held apart from the run', async () => {
  await page.locator('.time-bar').getByRole('button', { name: 'Live' }).click();
  await bar('Pause or go on').click();
  const held = await shownTime();
  const end = () => page.getByLabel('Time of the run').getAttribute('max').then(Number);
  const before = await end();
  await expect.poll(end, { timeout: 10_000 }).toBeGreaterThan(before + 3);
  expect(await shownTime()).toBe(held);
  await page.locator('.time-bar').getByRole('button', { name: 'view held' }).click();
  await expect.poll(shownTime).toBeGreaterThan(held);
});

test('the goal is reached, the run ends well, and its report opens', async () => {
  await page.locator('.run-bar select').selectOption('0');
  await page
    .locator('.events')
    .getByText(/goal 1 at cell .*: reached/)
    .waitFor({ timeout: 30_000 });
  await expect.poll(state, { timeout: 30_000 }).toBe('done');
  expect(await page.locator('.outcome').innerText()).toContain('did its task');
  // However fast it was, no tick is missing any more: five steps back are five ticks of a second.
  const end = Math.round(await shownTime());
  await expect
    .poll(async () => {
      await page.getByLabel('Time of the run').press('End');
      await page.locator('.canvas').focus();
      for (let i = 0; i < 5; i += 1) await page.keyboard.press(',');
      return Math.round(await shownTime());
    })
    .toBe(end - 5);
  const href = await page.locator('.outcome a').getAttribute('href');
  const answer = await page.request.get(new URL(href ?? '', studio.url).href);
  expect(answer.status()).toBe(200);
  expect(await answer.text()).toContain('<html');
  await shot(page, 'done');
});

test('the recorded run shows the same, by time', async () => {
  await page.getByRole('button', { name: 'Look at it again' }).click();
  await page.locator('.recording-bar').waitFor();
  expect(await shownTime()).toBe(0);
  const slider = page.getByLabel('Time of the run');
  await slider.focus();
  await page.keyboard.press('ArrowRight');
  await expect.poll(shownTime).toBe(1);
  await slider.evaluate((element: HTMLInputElement) => {
    const set = Object.getOwnPropertyDescriptor(HTMLInputElement.prototype, 'value')?.set;
    set?.call(element, `${Number(element.max) / 2}`);
    element.dispatchEvent(new Event('input', { bubbles: true }));
  });
  await expect.poll(shownTime).toBeGreaterThan(10);
  await shot(page, 'replay');
  await page.getByRole('button', { name: 'Close the recording' }).click();
});

test('a run is stopped and started again from the start', async () => {
  await page.locator('.run-bar select').selectOption('1');
  await bar('Start again').click();
  await expect.poll(state).toBe('armed'); // as it was configured
  await bar('Pause or go on').click();
  await expect.poll(state).toBe('running');
  await bar('Stop').click();
  await expect.poll(state, { timeout: 10_000 }).toBe('done');
});

test('who drives and who is suppressed is told for the Nimrod', async () => {
  const other = await studio.page(kLooks[0].options);
  await open(other, 'nimrod/controller.toml');
  await other.locator('.run-bar select').selectOption('0');
  await other.locator('.canvas').focus();
  await other.keyboard.press('F5');
  await expect.poll(() => other.locator('.drives-driving').count(), { timeout: 20_000 }).toBe(1);
  await expect.poll(() => other.locator('.run-now b').innerText(), { timeout: 30_000 }).toBe('done');
  await shot(other, 'nimrod_run');
  await other.context().close();
});
