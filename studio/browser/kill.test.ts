import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { afterAll, beforeAll, expect, onTestFailed, test } from 'vitest';
import { box } from './build';
import { open, Studio, shot } from './studio';

const kFile = 'nimrod/controller.toml';
let studio: Studio;
beforeAll(async () => {
  studio = await Studio.start();
});
afterAll(() => studio?.stop());

const onDisk = () => readFileSync(join(studio.folder, kFile), 'utf8');
const answered = (page: Page, path: string) =>
  page.waitForResponse((answer) => answer.url().endsWith(path) && answer.status() === 200, { timeout: 20_000 });
const press = async (page: Page, keys: string) => {
  await page.locator('.canvas').focus();
  await page.keyboard.press(keys);
};

async function rename(page: Page, from: string, to: string): Promise<void> {
  await box(page, from).locator('.box-names').click();
  await press(page, 'F2');
  await page.getByRole('dialog').getByRole('textbox').fill(to);
  await page.keyboard.press('Enter');
  await box(page, to).waitFor();
}

test('what was saved or autosaved is there again, whenever the server is killed', async () => {
  const page = await studio.page();
  onTestFailed(() => shot(page, 'failed_kill'));
  let name = 'hold';
  for (let round = 0; round < 4; round += 1) {
    await open(page, kFile);
    const recover = page.getByRole('button', { name: 'Recover the draft' });
    if (round > 0) await recover.or(box(page, name)).first().waitFor();
    if ((await recover.count()) > 0) await recover.click();
    await box(page, name).waitFor();
    const next = `kept_${round}`;
    const autosaved = answered(page, '/api/file/autosave');
    await rename(page, name, next);
    await autosaved;
    name = next;
    if (round % 2 === 1) {
      const saved = answered(page, '/api/file/save');
      await press(page, 'Control+s');
      await saved;
      expect(onDisk()).toContain(`id = "${name}"`);
    }
    await press(page, 'Alt+ArrowDown'); // another edit is on its way when the server ends
    await page.waitForTimeout((round * 397) % 1000);
    await studio.kill();
    await studio.restart();
    await page.goto(studio.url);
    await page.locator('.shell').waitFor();
  }
  await open(page, kFile);
  await box(page, name).waitFor();
  await page.context().close();
});

test('edits made while the server is away wait, visibly, and are sent when it is back', async () => {
  const page = await studio.page();
  onTestFailed(() => shot(page, 'failed_away'));
  await open(page, kFile);
  await box(page, 'avoid').locator('.box-names').click();
  await studio.kill();
  const field = page.locator('.field', { has: page.locator('label', { hasText: /^commit_s/ }) });
  await field.locator('input').fill('3.5');
  await field.locator('input').press('Enter');
  await box(page, 'arbiter').locator('.box-names').click();
  await page.locator('.right h2', { hasText: 'arbiter' }).waitFor();
  await press(page, 'Delete');
  await page.locator('.offline', { hasText: '2 changes wait' }).waitFor();
  await shot(page, 'not_connected');
  await studio.restart();
  await page.locator('.offline', { hasText: 'started anew' }).waitFor();
  const other = await page.context().newPage(); // the address that the server printed, in the same browser
  await other.goto(studio.url);
  await box(page, 'arbiter').waitFor({ state: 'detached', timeout: 20_000 });
  await page.locator('.offline').waitFor({ state: 'detached', timeout: 20_000 });
  const saved = answered(page, '/api/file/save');
  await press(page, 'Control+s');
  await saved;
  expect(onDisk()).toContain('commit_s = 3.5');
  expect(onDisk()).not.toContain('id = "arbiter"');
  await page.context().close();
});
