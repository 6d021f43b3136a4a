import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { afterAll, beforeAll, expect, onTestFailed, test } from 'vitest';
import { englishIn } from './english';
import { Robot } from './robot';
import { kLooks, open, runDrawn, Studio, shot } from './studio';

let studio: Studio;
let page: Page;
let robot: Robot;
beforeAll(async () => {
  studio = await Studio.start();
  robot = await Robot.start(studio.folder, 'nimrod');
  page = await studio.page(kLooks[2].options);
});
afterAll(async () => {
  await robot?.kill();
  await studio?.stop();
});

const kShown = '.head, .centre, .toasts, dialog';
const bar = (name: string) => page.locator('.run-bar').getByRole('button', { name, exact: true });
const state = () => page.locator('.run-now b').innerText();
const ended = () => expect.poll(state, { timeout: 30_000 }).toBe('terminada');
const run = () => runDrawn(page);
const noEnglish = async (name: string) => {
  await shot(page, `spanish_${name}`);
  expect(await englishIn(page, kShown)).toEqual([]);
};

test('problems of a broken drawing', async () => {
  const file = join(studio.folder, 'nimrod', 'controller.toml');
  let text = readFileSync(file, 'utf8');
  for (const [old, by] of [
    ['kind = "AvoidObstacle"', 'kind = "AvoidObstcle"'],
    ['in.left = "clear_left.range"\n', ''],
    ['in.right = "clear_right.range"', 'in.right = "heading"'],
    ['trigger_range_m = 0.10', 'trigger_range_m = -1'],
    ['channel = "compass.heading"', 'channel = "compass.headin"'],
    ['name = "Nimrod"', 'name = "Nimrod"\nshade = 3'],
  ])
    text = text.replace(old, by);
  writeFileSync(join(studio.folder, 'nimrod', 'roto.toml'), text);
  await page.reload();
  await open(page, 'nimrod/roto.toml');
  await page.locator('.problems-head.bad').click();
  expect(await page.locator('.problem').count()).toBeGreaterThan(4);
  await noEnglish('problems');
  const connect = page.locator('.problems').getByRole('button', { name: 'Conectar…' }).first();
  await connect.click();
  await page.getByRole('dialog').waitFor();
  await page.keyboard.press('Escape');
  await page.locator('.canvas').focus();
  await page.keyboard.press('F5');
  await page.locator('.toast.bad').first().waitFor();
  await noEnglish('blocked');
  await page.locator('.problems-head').click();
});

test('a refused wire', async () => {
  await page.reload(); // the view begins whole
  await open(page, 'nimrod/controller.toml');
  onTestFailed(() => shot(page, 'failed_spanish'));
  const to = page.locator('.box[data-component="escape"] [data-handleid="i:left"]');
  await page.locator('.box[data-component="heading"] .react-flow__handle.source').hover();
  await page.mouse.down();
  await to.hover();
  await page.waitForTimeout(300);
  await to.hover();
  await page.mouse.up();
  await page.locator('.toast.bad', { hasText: 'rad' }).waitFor();
  await noEnglish('refused');
});

test('a connection that is tested, a finished run, and a lost link', async () => {
  await bar('Configurar…').click();
  const dialog = page.getByRole('dialog');
  await dialog.getByLabel('Aplicación').selectOption('address');
  await dialog.getByLabel('Dirección').fill(robot.address);
  await dialog.getByRole('button', { name: 'Probar la conexión' }).click();
  await dialog.getByText('Todo está en orden').waitFor({ timeout: 30_000 });
  await shot(page, 'spanish_tested');
  expect(await englishIn(page, '.findings')).toEqual([]);
  await dialog.getByLabel('Duración').fill('8');
  await dialog.getByRole('button', { name: 'Hecho' }).click();
  await page.locator('.run-bar select').selectOption('0');
  await run();
  await ended();
  await page.locator('.outcome').waitFor();
  await noEnglish('finished');
  await page.locator('.run-bar select').selectOption('1');
  await run();
  await expect.poll(state).toBe('en marcha');
  await robot.kill();
  await ended();
  await page.locator('.outcome', { hasText: 'enlace perdido' }).waitFor();
  await noEnglish('lost');
  await run();
  await page.locator('.outcome', { hasText: 'nada responde' }).waitFor({ timeout: 20_000 });
  await noEnglish('nobody');
});
