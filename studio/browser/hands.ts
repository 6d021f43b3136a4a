import type { Page } from 'playwright-core';
import { box, type Hand } from './build';

async function point(page: Page, selector: string): Promise<[number, number]> {
  const area = await page.locator(selector).boundingBox();
  if (!area) throw new Error(`${selector} is not in sight`);
  return [area.x + area.width / 2, area.y + area.height / 2];
}

async function drag(page: Page, from: [number, number], to: [number, number]): Promise<void> {
  await page.mouse.move(...from);
  await page.mouse.down();
  await page.mouse.move((from[0] + to[0]) / 2, (from[1] + to[1]) / 2, { steps: 4 });
  await page.mouse.move(...to, { steps: 4 });
  await page.mouse.up();
}

function handle(id: string, side: 'source' | 'target', name: string): string {
  return `.box[data-component="${id}"] .react-flow__handle.${side}[data-handleid="${side === 'source' ? 'o' : 'i'}:${name}"]`;
}

async function renameShown(page: Page, id: string): Promise<void> {
  await page.getByRole('dialog').getByRole('textbox').fill(id);
  await page.getByRole('dialog').locator('button[type=submit]').click();
}

async function fitted(page: Page): Promise<void> {
  await page.getByRole('button', { name: 'Fit', exact: true }).click();
  await page.waitForTimeout(250);
}

async function choose(page: Page, label: string, value: string): Promise<void> {
  await page.locator('.right').getByLabel(label, { exact: true }).selectOption(value);
}

/** Mouse only: drag from the palette, draw wires by hand, click in forms. Text itself is typed. */
export const kMouse: Hand = {
  async start(page, plan) {
    await page.getByRole('button', { name: 'New controller…' }).click();
    await page.getByLabel('Robot', { exact: true }).selectOption(plan.robot);
    await page.getByLabel('File', { exact: true }).fill(plan.file);
    await page.getByLabel('Name', { exact: true }).fill(plan.name);
    await page.getByRole('button', { name: 'Create' }).click();
    await page.locator('.canvas-empty').waitFor();
  },
  async add(page, label, id, index) {
    const offer = page.locator(`[data-offer="${label}"]`);
    const canvas = await page.locator('.canvas').boundingBox();
    if (!canvas) throw new Error('no canvas');
    await offer.scrollIntoViewIfNeeded();
    const [column, row] = [Math.floor(index / 3), index % 3];
    const at = { x: 20 + column * (canvas.width / 4), y: 30 + row * (canvas.height / 3.6) };
    await offer.dragTo(page.locator('.canvas'), { targetPosition: at });
    await page.locator('.box').nth(index).waitFor();
    const shown = await page.locator('.box.selected').getAttribute('data-component');
    if (shown !== id) {
      await page
        .locator('.right')
        .getByRole('button', { name: shown ?? '', exact: true })
        .first()
        .click();
      await renameShown(page, id);
    }
    await box(page, id).waitFor();
  },
  async wire(page, { from, id, port, previous }) {
    const [source, output = ''] = from.split('.');
    await fitted(page);
    const start = handle(source, 'source', output);
    if ((await page.locator(start).count()) === 0) await box(page, source).locator('.port-more').click();
    await drag(page, await point(page, start), await point(page, handle(id, 'target', port)));
    await page.locator(`.react-flow__edge[data-id^="${id}|${port}|${from}"]`).waitFor({ state: 'attached' });
    if (!previous) return;
    await box(page, id).locator('.box-names').click();
    const toggle = page.locator('.right').getByLabel(`${from}: value of the previous tick`);
    if (!(await toggle.isChecked())) await toggle.click();
    await page.locator(`.react-flow__edge[data-id="${id}|${port}|${from}@previous"]`).waitFor({ state: 'attached' });
  },
  async set(page, id, key, value) {
    if (id === '') {
      await page.locator('.react-flow__pane').click({ position: { x: 4, y: 4 } });
      await page.locator('.right').getByLabel('Tick [s]').fill(value);
      await page.locator('.right h3').first().click();
      return;
    }
    await box(page, id).locator('.box-names').click();
    const field = page
      .locator('.right')
      .locator('.field', { has: page.locator('label', { hasText: new RegExp(`^${key}( \\[|$)`) }) });
    await field.locator('input').fill(value);
    await field.locator('input').press('Enter');
    await field.locator('button').waitFor();
  },
  async command(page, id, name) {
    await box(page, id).locator('.box-names').click();
    await choose(page, 'Drives the command', name);
    await box(page, id).getByText(`→ ${name}`).waitFor();
  },
  async run(page) {
    const bar = page.locator('.run-bar');
    await bar.getByRole('button', { name: 'Configure…' }).click();
    const dialog = page.getByRole('dialog');
    await dialog.getByLabel('Application').selectOption('simulation');
    await dialog.getByRole('button', { name: 'Test connection' }).click();
    await dialog.getByText('the simulation is ready').waitFor();
    await dialog.getByRole('button', { name: 'Done' }).click();
    await bar.locator('select').selectOption('0');
    await bar.getByRole('button', { name: 'Run', exact: true }).click();
  },
  async save(page) {
    await page.getByRole('button', { name: 'Save', exact: true }).click();
    await page.locator('.head').getByText('saved', { exact: true }).waitFor();
  },
};

async function onDrawing(page: Page): Promise<void> {
  await page.locator('.canvas').focus();
}

/** Selects by the search dialog: no pointer anywhere. */
export async function find(page: Page, id: string): Promise<void> {
  await onDrawing(page);
  await page.keyboard.press('Control+F');
  await page.keyboard.type(id);
  await page.locator('.options [role=option]').first().waitFor();
  await page.keyboard.press('Enter');
  await page.locator('.right h2', { hasText: id }).waitFor();
}

async function commandPalette(page: Page, words: string): Promise<void> {
  await page.keyboard.press('Control+K');
  await page.getByRole('dialog').waitFor();
  await page.keyboard.type(words);
  await page.keyboard.press('Enter');
}

/** Tab to the element, as one without a mouse must; fails if Tab never comes there. */
async function tabTo(page: Page, label: string, within = page.locator('body')): Promise<void> {
  const wanted = within
    .getByLabel(label, { exact: true })
    .or(within.getByTitle(label, { exact: true }))
    .first();
  for (let i = 0; i < 150; i += 1) {
    if (await wanted.evaluate((element) => element === document.activeElement)) return;
    await page.keyboard.press('Tab');
  }
  throw new Error(`Tab does not come to ${label}`);
}

/** Letters go to the option of a focused select that begins with them. */
async function pick(page: Page, words: string): Promise<void> {
  await page.keyboard.type(words);
}

/** Keyboard only. */
export const kKeyboard: Hand = {
  async start(page, plan) {
    await commandPalette(page, 'new controller');
    await page.getByRole('dialog', { name: 'New controller' }).waitFor();
    await page.locator('dialog option').first().waitFor({ state: 'attached' });
    await tabTo(page, 'Robot');
    await pick(page, plan.robot === 'nimrod/robot.toml' ? 'Nimrod' : 'Pathfinder');
    await tabTo(page, 'File');
    await page.keyboard.press('Control+A');
    await page.keyboard.type(plan.file);
    await page.keyboard.press('Tab');
    await page.keyboard.type(plan.name);
    await page.keyboard.press('Enter');
    await page.locator('.canvas-empty').waitFor();
  },
  async add(page, label, id, index) {
    await onDrawing(page);
    await page.keyboard.press(index === 0 ? 'Tab' : 'a');
    await page.locator('.options [role=option]').first().waitFor();
    await page.keyboard.type(label);
    await page.keyboard.press('Enter');
    await page.locator('.box').nth(index).waitFor();
    if ((await page.locator('.box.selected').getAttribute('data-component')) === id) return;
    await onDrawing(page);
    await page.keyboard.press('F2');
    await page.getByRole('dialog').waitFor();
    await page.keyboard.press('Control+A');
    await page.keyboard.type(id);
    await page.keyboard.press('Enter');
    await box(page, id).waitFor();
  },
  async wire(page, { from, id, port, previous }) {
    const [source] = from.split('.');
    await find(page, source);
    await onDrawing(page);
    await page.keyboard.press('c');
    await page.getByRole('dialog').waitFor();
    const which = page.getByRole('dialog').getByLabel('Output');
    if ((await which.count()) > 0 && (await which.inputValue()) !== from) {
      await page.keyboard.press('Tab');
      for (let i = 0; i < 40 && (await which.inputValue()) !== from; i += 1) await page.keyboard.press('ArrowDown');
    }
    if (previous) {
      await tabTo(page, 'Value of the previous tick');
      await page.keyboard.press('Space');
    }
    while (!(await page.getByRole('combobox', { name: 'Search' }).evaluate((one) => one === document.activeElement)))
      await page.keyboard.press('Shift+Tab');
    await page.keyboard.type(`${id}.${port}`);
    await page
      .getByRole('option', { name: `${id}.${port}`, exact: true })
      .first()
      .waitFor();
    await page.keyboard.press('Enter');
    const text = previous ? `${from}@previous` : from;
    await page.locator(`.react-flow__edge[data-id="${id}|${port}|${text}"]`).waitFor({ state: 'attached' });
  },
  async set(page, id, key, value) {
    if (id !== '') await find(page, id);
    else {
      await onDrawing(page);
      await page.keyboard.press('Escape');
    }
    await page
      .locator('.right')
      .getByLabel(key === 'tick_s' ? 'Tick [s]' : new RegExp(`^${key}( \\[.*)?$`))
      .first()
      .focus();
    await page.keyboard.press('Control+A');
    await page.keyboard.type(value);
    await page.keyboard.press('Enter');
    await page.waitForTimeout(150);
  },
  async command(page, id, name) {
    await find(page, id);
    await page.locator('.right').getByLabel('Drives the command', { exact: true }).focus();
    await pick(page, name);
    await box(page, id).getByText(`→ ${name}`).waitFor();
  },
  async run(page) {
    await onDrawing(page);
    await commandPalette(page, 'configure');
    await page.getByRole('dialog', { name: 'Configure' }).waitFor();
    await tabTo(page, 'Application');
    await pick(page, 'Built-in');
    await page.keyboard.press('Escape');
    await tabTo(page, 'Pace', page.locator('.run-bar'));
    await pick(page, 'max');
    await onDrawing(page);
    await page.keyboard.press('F5');
  },
  async save(page) {
    await onDrawing(page);
    await page.keyboard.press('Control+S');
    await page.locator('.head').getByText('saved', { exact: true }).waitFor();
  },
};
