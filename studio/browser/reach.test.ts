// Reaching into a running world: a click sets the goal, an obstacle is dragged elsewhere, and the recorded run tells of both.
import type { Page, WebSocket } from 'playwright-core';
import { afterAll, beforeAll, expect, test } from 'vitest';
import { kLooks, open, Studio, shot } from './studio';

interface Mover {
  id: string;
  x_m: number;
  y_m: number;
}

let studio: Studio;
let page: Page;
/** The newest sample of the movers that came. */
let movers: Mover[] = [];

function moversOf(bytes: Buffer): Mover[] | null {
  return bytes.length > 16 && bytes[0] === 4 ? JSON.parse(bytes.subarray(16).toString()).movers : null;
}

function listen(socket: WebSocket): void {
  socket.on('framereceived', ({ payload }) => {
    if (typeof payload !== 'string') movers = moversOf(payload) ?? movers;
  });
}

beforeAll(async () => {
  studio = await Studio.start();
  page = await studio.page();
  page.on('websocket', listen);
  await page.reload();
  await open(page, 'pathfinder/controller.toml');
});
afterAll(() => studio?.stop());

const kWorld = { width_m: 12, height_m: 10, margin: 16 };

interface Box {
  x: number;
  y: number;
  width: number;
  height: number;
}

/** The canvas once it has been drawn twice at the same place: what comes below it takes its room. */
async function settled(of: Page): Promise<Box> {
  return of.locator('.world-frame canvas').evaluate(async (canvas) => {
    const box = () => {
      const { x, y, width, height } = canvas.getBoundingClientRect();
      return { x, y, width, height };
    };
    let before = box();
    for (let same = 0; same < 4; ) {
      await new Promise(requestAnimationFrame);
      const now = box();
      same = JSON.stringify(now) === JSON.stringify(before) ? same + 1 : 0;
      before = now;
    }
    return before;
  });
}

/** Where on the screen a point of the rooms is: the world is seen whole. */
async function onScreen(of: Page, x_m: number, y_m: number): Promise<[number, number]> {
  const box = await settled(of);
  const { width_m, height_m, margin } = kWorld;
  const below = margin + Math.min(40, box.height / 8); // for the buttons
  const scale = Math.min((box.width - 2 * margin) / width_m, (box.height - margin - below) / height_m);
  return [
    box.x + box.width / 2 + (x_m - width_m / 2) * scale,
    box.y + (box.height + margin - below) / 2 - (y_m - height_m / 2) * scale,
  ];
}

async function colourAt(of: Page, x_m: number, y_m: number): Promise<string> {
  const [x, y] = await onScreen(of, x_m, y_m);
  return of.locator('.world-frame canvas').evaluate(
    (canvas: HTMLCanvasElement, [px, py]) => {
      const box = canvas.getBoundingClientRect();
      const ratio = canvas.width / box.width;
      const data = canvas.getContext('2d')?.getImageData((px - box.x) * ratio, (py - box.y) * ratio, 1, 1).data;
      return `${data?.[0]},${data?.[1]},${data?.[2]}`;
    },
    [x, y] as const,
  );
}

async function drag(of: Page, from: [number, number], to: [number, number]): Promise<void> {
  await of.mouse.move(...(await onScreen(of, ...from)));
  await of.mouse.down();
  await of.mouse.move(...(await onScreen(of, (from[0] + to[0]) / 2, (from[1] + to[1]) / 2)), { steps: 3 });
  await of.mouse.move(...(await onScreen(of, ...to)), { steps: 3 });
}

const events = (of = page) => of.locator('.events');
const state = () => page.locator('.run-now b').innerText();
const kGoal = '255,210,31'; // --world-goalmark of the light look
const kMover = '154,162,171'; // --world-mover

test('the pathfinder waits among crates; the page says what a pointer can do', async () => {
  await page.locator('.run-bar').getByRole('button', { name: 'Configure…', exact: true }).click();
  const dialog = page.getByRole('dialog');
  await dialog.getByLabel('Experiment').selectOption('pathfinder/experiment.toml');
  await dialog.getByLabel('World').selectOption('pathfinder/rooms_moving.toml');
  await dialog.getByLabel('Wait before the first tick').check();
  await dialog.getByRole('button', { name: 'Done' }).click();
  await page.locator('.run-bar select').selectOption('0.5');
  await page.locator('.canvas').focus();
  await page.keyboard.press('F5');
  await page.keyboard.press('Alt+3');
  await expect.poll(state).toBe('armed');
  await expect.poll(() => page.locator('.world-hint').innerText()).toContain('Click on free ground');
});

test('a click sets the goal, and its mark stands there, though the run waits', async () => {
  await page.mouse.move(...(await onScreen(page, 2.35, 9.4)));
  await expect.poll(() => page.locator('.world-frame canvas').evaluate((one) => one.style.cursor)).toBe('crosshair');
  await shot(page, 'reach_hover');
  await page.mouse.click(...(await onScreen(page, 2.35, 9.4)));
  await events().getByText('by hand: goal at 2.').waitFor();
  await events()
    .getByText(/goal 1 at cell .*: replaced/)
    .waitFor();
  await events()
    .getByText(/goal 2 at cell .*: set/)
    .waitFor();
  await page.mouse.move(5, 5);
  await expect.poll(() => colourAt(page, 2.14, 9.25)).toBe(kGoal);
});

test('a click on a wall says why it cannot be', async () => {
  await page.mouse.click(...(await onScreen(page, 4.25, 9)));
  await page.locator('.toast.bad').getByText('there is no room for the robot').waitFor();
  await page.locator('.toast.bad button').first().click();
});

test('an obstacle is dragged, shows as a ghost, and stands there in the samples', async () => {
  await page.locator('.run-bar').getByRole('button', { name: 'Pause or go on', exact: true }).click();
  await expect.poll(state).toBe('running');
  await expect.poll(() => movers.length).toBeGreaterThan(0);
  const crate = movers.find((one) => one.id === 'crate_1'); // it moves by itself as well
  await drag(page, [crate?.x_m ?? 0, crate?.y_m ?? 0], [5.75, 9.25]);
  await shot(page, 'reach_drag');
  await page.mouse.up();
  await events().getByText('by hand: crate_1 to 5.7').waitFor();
  await expect.poll(() => movers.find((one) => one.id === 'crate_1')?.x_m ?? 0).toBeCloseTo(5.75, 1);
  expect(movers.find((one) => one.id === 'crate_1')?.y_m).toBeCloseTo(9.25, 1);
  expect(await page.locator('.time-mark').count()).toBe(2);
});

test('a drag into a wall is refused with the reason; escape lets go', async () => {
  const before = movers.find((one) => one.id === 'crate_1');
  await drag(page, [5.75, 9.25], [8, 8.5]);
  await page.mouse.up();
  await page.locator('.toast.bad').getByText('a wall or something solid is there').waitFor();
  await page.locator('.toast.bad button').first().click();
  await drag(page, [5.75, 9.25], [5.25, 9.25]);
  await page.keyboard.press('Escape');
  await page.mouse.up();
  expect(movers.find((one) => one.id === 'crate_1')).toEqual(before);
  expect(await page.locator('.time-mark').count()).toBe(2);
});

test('the same goes by keyboard, in Spanish as well', async () => {
  await page.keyboard.press('g');
  const goal = page.getByRole('dialog', { name: 'Set a goal' });
  await goal.getByLabel('x [m]').fill('0.75');
  await page.keyboard.press('Enter');
  await goal.getByText('Write two numbers.').waitFor();
  await goal.getByLabel('y [m]').fill('8,25');
  await page.keyboard.press('Enter');
  await events().getByText('by hand: goal at 0.75, 8.25').waitFor();
  const other = await studio.page(kLooks[2].options);
  await other.keyboard.press('Alt+3');
  await other.locator('.world-hint').getByText('Pulse en suelo libre').waitFor();
  await other.keyboard.press('Control+K');
  await other.getByRole('dialog').waitFor();
  await other.keyboard.type('Mover un obst');
  await other.keyboard.press('Enter');
  const obstacle = other.getByRole('dialog', { name: 'Mover un obstáculo' });
  await obstacle.getByLabel('Obstáculo').selectOption('crate_2');
  await obstacle.getByLabel('x [m]').fill('4.25');
  await obstacle.getByLabel('y [m]').fill('9');
  await other.keyboard.press('Enter');
  await other.locator('.toast.bad').getByText('hay una pared o algo sólido').waitFor();
  await other.context().close();
});

test('a finger does the same on a phone', async () => {
  const phone = await studio.page(kLooks[3].options);
  await phone.locator('.phone-tabs').getByRole('button', { name: 'World' }).click();
  await phone.locator('.world-hint').waitFor();
  await phone.touchscreen.tap(...(await onScreen(phone, 1.25, 9.25)));
  await events(phone).getByText('by hand: goal at 1.').waitFor();
  await shot(phone, 'reach_phone');
  await phone.context().close();
});

test('the recorded run tells of it all, and nothing can be reached in it', async () => {
  await page.locator('.run-bar').getByRole('button', { name: 'Stop', exact: true }).click();
  await expect.poll(state).toBe('done');
  expect(await page.locator('.outcome').innerText()).toContain('interventions: 4');
  await page.getByRole('button', { name: 'Look at it again' }).click();
  await page.locator('.recording-bar').waitFor();
  for (const words of ['by hand: goal at 2.', 'by hand: crate_1 to 5.7', 'by hand: goal at 0.75, 8.25']) {
    await events().getByText(words).waitFor();
  }
  expect(await page.locator('.time-mark').count()).toBe(4);
  expect(await page.locator('.world-hint').count()).toBe(0);
  await page.mouse.click(...(await onScreen(page, 4.25, 9))); // a wall: live it would be refused
  await events().getByText('by hand: crate_1 to 5.7').click();
  await expect.poll(() => colourAt(page, 5.85, 9.35)).toBe(kMover);
  await shot(page, 'reach_recorded');
  expect(await page.locator('.toast.bad', { hasText: 'no room for the robot' }).count()).toBe(0);
});
