import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { afterAll, beforeAll, expect, test } from 'vitest';
import { Studio, shot } from './studio';
import { plain } from './toml';

let studio: Studio;
beforeAll(async () => {
  studio = await Studio.start();
});
afterAll(() => studio?.stop());

/** Boxes that are not whole within the canvas. */
function outOfSight(boxes: Element[]): (string | null)[] {
  const seen = document.querySelector('.canvas')?.getBoundingClientRect() ?? new DOMRect();
  const whole = (one: DOMRect) => one.left >= seen.left && one.right <= seen.right;
  return boxes.filter((box) => !whole(box.getBoundingClientRect())).map((box) => box.getAttribute('data-component'));
}

test('the tour leads a newcomer from nothing to figure 6, and to a run that reaches its goal', async () => {
  const page = await studio.page();
  await page.keyboard.press('Control+k');
  await page.keyboard.type('tour');
  await page.keyboard.press('Enter');
  const tour = page.getByRole('region', { name: 'Tour' });
  const now = () => tour.locator('[aria-current=step]').innerText();
  await expect.poll(now).toContain('Start a new controller');
  await tour.locator('button.primary').click();
  await page.getByLabel('Robot', { exact: true }).selectOption('pathfinder/robot.toml');
  await page.getByLabel('File', { exact: true }).fill('toured');
  await page.getByLabel('Name', { exact: true }).fill('Pathfinder');
  await page.getByRole('button', { name: 'Create' }).click();
  const steps = ['Add the sensations', 'GridCell', 'goal App', 'DynamicMapRouter', 'Connect goal', 'drive the command'];
  for (const step of steps) {
    await expect.poll(now).toContain(step);
    await tour.getByRole('button', { name: 'Do it for me' }).click();
  }
  await expect.poll(now).toContain('then Run');
  await shot(page, 'tour');
  expect(await page.locator('.problems-head').innerText()).toBe('No problems');
  await page.locator('.run-bar select').selectOption('0');
  await tour.getByRole('button', { name: 'Run', exact: true }).click();
  await page.locator('.outcome').getByText('did its task').waitFor({ timeout: 40_000 });
  await tour.getByText('this is figure 6').waitFor();
  // The world stands beside the drawing now, which was made to fit.
  await expect.poll(() => page.locator('.box').evaluateAll(outOfSight)).toEqual([]);
  await shot(page, 'toured');
  await page.keyboard.press('Control+s');
  await page.locator('.head').getByText('saved', { exact: true }).waitFor();
  // The tour keeps the defaults: the shipped file spells cell_m out, and weighs steps backwards by 1 instead of 2.
  const wiring = (file: string) =>
    plain(readFileSync(join(studio.folder, 'pathfinder', file), 'utf8')).map((section) =>
      section.replace(/^(cell_m|backward_weight) = .*\n/gm, ''),
    );
  expect(wiring('toured.toml')).toEqual(wiring('controller.toml'));
  await page.context().close();
});
