import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { afterAll, beforeAll, beforeEach, expect, test } from 'vitest';
import { box } from './build';
import { kLooks, open, Studio } from './studio';

const kFile = 'nimrod/controller.toml';
let studio: Studio;
let page: Page;
let text: string;

const onDisk = () => readFileSync(join(studio.folder, kFile), 'utf8');
const dirty = () => page.locator('.head').getByText('not saved', { exact: true });
const press = async (...keys: string[]) => {
  await page.locator('.canvas').focus();
  for (const key of keys) await page.keyboard.press(key);
};
const boxes = () => page.locator('.box').count();

beforeAll(async () => {
  studio = await Studio.start();
  text = onDisk();
});
afterAll(() => studio?.stop());
beforeEach(async () => {
  writeFileSync(join(studio.folder, kFile), text);
  await page?.context().close();
  page = await studio.page();
  await open(page, kFile);
  const discard = page.getByRole('button', { name: 'Discard the draft' });
  if ((await discard.count()) > 0) await discard.click();
});

test('the palette finds kinds by word, and Enter adds one', async () => {
  await page.locator('.left .tabs').getByText('Add').click();
  await page.getByLabel('Search components').fill('speed');
  await page.locator('[data-offer=ClosingSpeed]').focus();
  await page.keyboard.press('Enter');
  await box(page, 'closing_speed').waitFor();
});

test('a wire that does not fit is refused with the reason', async () => {
  const from = page.locator('.box[data-component="heading"] .react-flow__handle.source');
  const to = page.locator('.box[data-component="escape"] [data-handleid="i:left"]');
  const before = await page.locator('.react-flow__edge').count();
  await from.hover();
  await page.mouse.down();
  await to.hover();
  await page.waitForTimeout(300);
  await to.hover();
  await page.mouse.up();
  await page.locator('.toast.bad').waitFor();
  expect(await page.locator('.toast.bad').innerText()).toContain('rad');
  expect(await page.locator('.react-flow__edge').count()).toBe(before);
});

test('a wire let go over empty ground offers only what it fits, and connects it', async () => {
  const from = page.locator('.box[data-component="sonar_left"] .react-flow__handle.source');
  await from.hover();
  await page.mouse.down();
  await page.mouse.move(500, 650, { steps: 5 });
  await page.mouse.up();
  await page.locator('.options [role=option]').first().waitFor();
  const offered = await page.locator('.options [role=option]').allInnerTexts();
  expect(offered.some((one) => one.includes('ClosingSpeed'))).toBe(true);
  expect(offered.some((one) => one.includes('CompassDecoder'))).toBe(false);
  await page.getByRole('option', { name: /ClosingSpeed/ }).click();
  await page.locator('.react-flow__edge[data-id="closing_speed|range|sonar_left"]').waitFor({ state: 'attached' });
  await press('Control+z');
  await box(page, 'closing_speed').waitFor({ state: 'detached' });
});

test('problems show while drawing, lead to the culprit, hold Run back, and one click mends', async () => {
  await box(page, 'clear_left').locator('.box-names').click();
  await press('Delete');
  await page.locator('.problems-head.bad').waitFor();
  const count = Number((await page.locator('.problems-head').innerText()).match(/\d+/)?.[0]);
  expect(count).toBeGreaterThan(0);
  expect(await page.locator('.run-button .count').innerText()).toBe(`${count}`);
  await press('F5');
  await page.locator('.toast.bad').waitFor();
  await page.locator('.problem').first().click();
  const culprit = await page.locator('.problem b').first().innerText();
  expect(await page.locator('.box.selected').getAttribute('data-component')).toBe(culprit);
});

test('everything is undone and done again, keyboard moves as one step', async () => {
  const drawing = await box(page, 'hold').boundingBox();
  await box(page, 'hold').locator('.box-names').click();
  await press('Alt+ArrowDown', 'Alt+ArrowDown', 'Alt+ArrowDown');
  await dirty().waitFor();
  await page.waitForTimeout(300);
  expect((await box(page, 'hold').boundingBox())?.y).toBeGreaterThan((drawing?.y ?? 0) + 5);
  await press('Control+z');
  await dirty().waitFor({ state: 'detached' });
  await press('Control+Shift+Z');
  await dirty().waitFor();
});

test('copy, paste, duplicate, select all, cut', async () => {
  const before = await boxes();
  await box(page, 'hold').locator('.box-names').click();
  await press('Control+c', 'Control+v');
  await page.locator('.box').nth(before).waitFor();
  await press('Control+d');
  await page
    .locator('.box')
    .nth(before + 1)
    .waitFor();
  await press('Control+a');
  expect(await page.locator('.box.selected').count()).toBe(before + 2);
  await press('Control+x');
  await page.locator('.canvas-empty').waitFor();
  await press('Control+v');
  await page
    .locator('.box')
    .nth(before + 1)
    .waitFor();
});

test('align puts the chosen at one edge', async () => {
  await press('Control+a', 'Control+k');
  await page.keyboard.type('align left');
  await page.keyboard.press('Enter');
  await dirty().waitFor();
  await page.waitForTimeout(300);
  const edges = await page
    .locator('.box')
    .evaluateAll((all) => all.map((one) => Math.round(one.getBoundingClientRect().left)));
  expect(Math.max(...edges) - Math.min(...edges)).toBeLessThanOrEqual(3);
});

test('a parameter is set and put back to its default by its form', async () => {
  await box(page, 'avoid').locator('.box-names').click();
  const field = page.locator('.field', { has: page.locator('label', { hasText: /^commit_s/ }) });
  await field.locator('input').fill('3,5');
  await field.locator('input').press('Enter');
  await field.locator('button').click();
  await expect.poll(() => field.locator('input').inputValue()).toBe('2');
  await field.locator('input').fill('fast');
  await field.locator('input').press('Enter');
  await field.getByText('Not a number').waitFor();
});

test('saving writes the file, and undo makes the drawing dirty again', async () => {
  await box(page, 'hold').locator('.box-names').click();
  await press('F2');
  await page.getByRole('dialog').getByRole('textbox').fill('keep');
  await page.keyboard.press('Enter');
  await box(page, 'keep').waitFor();
  await press('Control+s');
  await dirty().waitFor({ state: 'detached' });
  expect(onDisk()).toContain('in.commands = ["escape", "avoid", "keep"]');
  await press('Control+z');
  await dirty().waitFor();
});

test('a file changed elsewhere is followed while clean and asked about while dirty', async () => {
  writeFileSync(join(studio.folder, kFile), text.replace('name = "Nimrod"', 'name = "Theirs"'));
  await page.locator('.head-name', { hasText: 'Theirs' }).waitFor();
  await box(page, 'hold').locator('.box-names').click();
  await press('Delete');
  await dirty().waitFor();
  writeFileSync(join(studio.folder, kFile), text);
  await page.locator('.banner', { hasText: 'changed on the disk' }).waitFor();
  await page.getByRole('button', { name: 'Take the one on the disk' }).click();
  await box(page, 'hold').waitFor();
});

test('the draft survives a killed server and is offered again', async () => {
  await box(page, 'hold').locator('.box-names').click();
  await press('Delete');
  await page.waitForTimeout(1500);
  await studio.kill();
  expect(onDisk()).toBe(text);
  await studio.restart();
  await page.context().close();
  page = await studio.page();
  await open(page, kFile);
  await page.getByRole('button', { name: 'Recover the draft' }).click();
  await box(page, 'hold').waitFor({ state: 'detached' });
});

test('a broken file still opens, shows what it can, and says what is wrong', async () => {
  writeFileSync(
    join(studio.folder, 'nimrod/broken.toml'),
    text.replace('kind = "Escape"', 'kind = "Escap"\nshade = 3'),
  );
  await page.reload();
  await open(page, 'nimrod/broken.toml');
  expect(await boxes()).toBe(9);
  await page.locator('.problems-head.bad').click();
  await page.locator('.problem', { hasText: 'Escape' }).first().waitFor();
});

test('the table selects, and minimap, search and tidy work', async () => {
  await page.keyboard.press('Alt+2');
  await page.getByRole('button', { name: 'Select hold' }).click();
  await page.locator('.right h2', { hasText: 'hold' }).waitFor();
  await page.keyboard.press('Alt+1');
  await box(page, 'hold').waitFor();
  await press('m');
  await page.locator('.react-flow__minimap').waitFor();
  await press('Control+f');
  await page.keyboard.type('arb');
  await page.keyboard.press('Enter');
  await page.locator('.right h2', { hasText: 'arbiter' }).waitFor();
  await press('Control+k');
  await page.keyboard.type('tidy');
  await page.keyboard.press('Enter');
  await dirty().waitFor();
});

test('the keys are all listed, and language and colours change at once', async () => {
  await press('?');
  expect(await page.locator('table.keys tr').count()).toBeGreaterThan(25);
  await page.keyboard.press('Escape');
  await press('Control+k');
  await page.keyboard.type('español');
  await page.keyboard.press('Enter');
  await page.getByText('Propiedades').first().waitFor({ state: 'attached' });
  await page.locator('.tabs').getByText('Dibujo').first().waitFor();
  expect(kLooks).toHaveLength(4);
});
