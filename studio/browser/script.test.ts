import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { afterAll, beforeAll, expect, test } from 'vitest';
import { open, Studio } from './studio';

// A controller that somebody else wrote, with markup in every text it holds. The page's policy refuses scripts in HTML
// as well, so it does not do to look for what a script has done: no element may have come of it.
const kMarkup = '<img class="evil" src="x" onerror="window.attacked=1"><script class="evil">window.attacked=1</script>';
const kFile = 'nimrod/controller.toml';
const kShort = '<b class="evil">b</b>';

let studio: Studio;
let page: Page;

beforeAll(async () => {
  studio = await Studio.start();
  const toml = JSON.stringify(kMarkup);
  const inside = (name: string) => join(studio.folder, 'nimrod', name);
  const controller = readFileSync(inside('controller.toml'), 'utf8');
  writeFileSync(inside('plain.toml'), controller.replace('name = "Nimrod"', `name = ${toml}`));
  const experiment = readFileSync(inside('experiment.toml'), 'utf8')
    .replace(/name = .*/, `name = ${toml}`)
    .replace('"controller.toml"', '"plain.toml"')
    .replace(/duration_s = \d+/, 'duration_s = 2');
  writeFileSync(inside('evil.toml'), experiment);
  writeFileSync(
    inside('controller.toml'),
    `format = 1\nname = ${toml}\nrobot = "robot.toml"\n
[[sensation]]\nid = ${JSON.stringify(kShort)}\nchannel = ${JSON.stringify(kShort)}\n
[[acting]]\nid = ${toml}\nkind = ${toml}\nin.left = ${toml}\nin.${toml} = ${toml}\n${toml} = ${toml}\n`,
  );
  page = await studio.page();
  await open(page, kFile);
});
afterAll(() => studio?.stop());

async function nothingCameOfIt(where: Page): Promise<void> {
  expect(await where.locator('.evil').count()).toBe(0);
  expect(await where.evaluate(() => 'attacked' in window)).toBe(false);
}

test('on the canvas a name that carries a script is text', async () => {
  const box = page.locator('.box.class-acting', { hasText: kMarkup });
  await expect.poll(() => box.count()).toBe(1);
  await nothingCameOfIt(page);
});

test('the inspector shows it as text', async () => {
  await page.locator('.canvas').focus();
  await page.keyboard.press('Control+f');
  await page.keyboard.type('onerror');
  await page.keyboard.press('Enter');
  await expect.poll(() => page.locator('.right h2').innerText()).toContain(kMarkup);
  await expect
    .poll(() =>
      page
        .locator('.right pre')
        .allInnerTexts()
        .then((all) => all.join()),
    )
    .toContain(`= "<img`);
  await nothingCameOfIt(page);
});

test('the problems show it as text', async () => {
  const head = page.locator('.problems-head');
  if ((await head.getAttribute('aria-expanded')) !== 'true') await head.click();
  await expect
    .poll(() =>
      page
        .locator('.problem')
        .allInnerTexts()
        .then((all) => all.join()),
    )
    .toContain('onerror');
  await nothingCameOfIt(page);
});

test('the table shows it as text', async () => {
  await page
    .getByRole('tab', { name: 'Table' })
    .or(page.getByRole('button', { name: 'Table', exact: true }))
    .first()
    .click();
  await expect.poll(() => page.locator('.table-view').innerText()).toContain(kMarkup);
  await nothingCameOfIt(page);
});

test('the report of a run shows it as text', async () => {
  const outcome = await page.evaluate(async () => {
    const post = (path: string, body: object) =>
      fetch(path, { method: 'POST', body: JSON.stringify(body) }).then((answer) => answer.json());
    const started = await post('/api/run/start', { experiment: 'nimrod/evil.toml', pace: 0 });
    if (started.error) return { problem: JSON.stringify(started), file: '' };
    for (;;) {
      const now = await fetch('/api/run').then((answer) => answer.json());
      if (now.state === 'done') return { problem: '', file: now.outcome.file as string };
      await new Promise((resolve) => setTimeout(resolve, 50));
    }
  });
  expect(outcome.problem).toBe('');
  const report = await page.context().newPage();
  await report.goto(`${new URL(page.url()).origin}/api/recording/report?path=${encodeURIComponent(outcome.file)}`);
  expect(await report.locator('body').innerText()).toContain(kMarkup);
  await nothingCameOfIt(report);
  await nothingCameOfIt(page);
});
