import { execFileSync, spawn } from 'node:child_process';
import { join } from 'node:path';
import type { Locator, Page } from 'playwright-core';
import { afterAll, beforeAll, expect, onTestFailed, test } from 'vitest';
import { Robot } from './robot';
import { kProgram, open, runDrawn, Studio, shot, urlOf } from './studio';

const kPrograms = `format = 1

[[program]]
name = "Nimrod's simulator"
help = "a program of its own"
command = ["${kProgram}", "sim", "experiment.toml", "--listen", "127.0.0.1:{port}"]

[[program]]
name = "Broken"
help = "ends at once"
command = ["/bin/sh", "-c", "echo no motor found; exit 3"]
`;

let studio: Studio;
let page: Page;
let robot: Robot;
beforeAll(async () => {
  studio = await Studio.start(kPrograms);
  robot = await Robot.start(studio.folder, 'nimrod');
  page = await studio.page();
  await open(page, 'nimrod/controller.toml');
});
afterAll(async () => {
  await robot?.kill();
  await studio?.stop();
});

const state = () => page.locator('.run-now b').innerText();
const bar = (name: string) => page.locator('.run-bar').getByRole('button', { name, exact: true });
const pace = (value: string) => page.locator('.run-bar select').selectOption(value);
const run = () => runDrawn(page);
const done = () => expect.poll(state, { timeout: 30_000 }).toBe('done');

async function configured(work: (dialog: Locator) => Promise<void>): Promise<void> {
  onTestFailed(() => shot(page, 'failed_link'));
  await bar('Configure…').click();
  const dialog = page.getByRole('dialog');
  try {
    await work(dialog);
  } finally {
    await dialog.getByRole('button', { name: 'Done' }).click();
  }
}

async function tested(dialog: Locator): Promise<string[]> {
  await dialog.getByRole('button', { name: 'Test connection' }).click();
  await dialog.getByText(/All is well|Not ready/).waitFor({ timeout: 30_000 });
  return dialog.locator('.findings li').allInnerTexts();
}

test("the folder's experiment.toml is the one that is chosen", async () => {
  await configured(async (dialog) => {
    await expect.poll(() => dialog.getByLabel('Experiment').inputValue()).toBe('nimrod/experiment.toml');
  });
});

test('a robot at an address is looked at: what it offers, how fast it answers, what differs', async () => {
  await configured(async (dialog) => {
    await dialog.getByLabel('Application').selectOption('address');
    await dialog.getByLabel('Address').fill(robot.address);
    const findings = await tested(dialog);
    await shot(page, 'test_connection');
    expect(findings.join('\n')).toMatch(/it is "Nimrod", 1 robot/);
    expect(findings.join('\n')).toMatch(/it answers within [\d.]+ ms/);
    expect(findings.join('\n')).toContain('it is the robot that the robot file describes');
    expect(await dialog.locator('.findings .bad').count()).toBe(0);
    await dialog.getByLabel('Duration').fill('20');
  });
});

test('a run over the address is paused, goes on, is stopped, and goes to its end', async () => {
  await pace('1');
  await run();
  await expect.poll(state).toBe('running');
  await bar('Pause or go on').click();
  await expect.poll(state).toBe('paused');
  await bar('Pause or go on').click();
  await expect.poll(state).toBe('running');
  await bar('Stop').click();
  await done();
  await pace('0');
  await run();
  await done();
  await expect.poll(() => page.locator('.outcome').innerText()).not.toContain('interrupted');
  expect(await page.locator('.outcome').innerText()).not.toContain('link lost');
});

test('a robot that dies on the way: the outcome says that the link was lost', async () => {
  await pace('1');
  await run();
  await expect.poll(state).toBe('running');
  await robot.kill();
  await done();
  expect(await page.locator('.outcome').innerText()).toContain('link lost');
  await shot(page, 'link_lost');
});

test('a robot that is not there: what to do is said, by the test and by the run', async () => {
  await configured(async (dialog) => {
    const findings = await tested(dialog);
    expect(findings[0]).toMatch(/nothing answers at .* Is the robot on\? .*ganglion sim/);
  });
  await run();
  await done();
  expect(await page.locator('.outcome').innerText()).toMatch(/nothing answers at .* Is the robot on\?/);
});

test('an address of another form is refused in words', async () => {
  await configured(async (dialog) => {
    await dialog.getByLabel('Address').fill('http://127.0.0.1:80/');
    await dialog.getByRole('button', { name: 'Test connection' }).click();
    await page.locator('.toast.bad', { hasText: 'tcp://HOST:PORT' }).waitFor();
  });
});

test('a listed program is started, tested, ended, and carries a run; one that fails says what it said', async () => {
  await configured(async (dialog) => {
    await dialog.getByLabel('Application').selectOption('program Broken');
    expect((await tested(dialog)).join('\n')).toContain('last said: no motor found');
    await dialog.getByLabel('Application').selectOption("program Nimrod's simulator");
    const findings = await tested(dialog);
    expect(findings.join('\n')).toMatch(/it is "Nimrod"/);
    expect(findings.at(-1)).toBe('the program was ended again');
    expect(await dialog.locator('.findings .bad').count()).toBe(0);
  });
  await pace('0');
  await run();
  await done();
  expect(await page.locator('.outcome').innerText()).toMatch(/duration over|stopped/);
});

test('a run of the command line is watched, not steered, and has the digest of one that nobody watches', async () => {
  const experiment = join(studio.folder, 'nimrod', 'experiment.toml');
  const wanted = [experiment, '--seed', '3', '--set', 'run.duration_s=8', '--no-record'];
  const alone = JSON.parse(execFileSync(kProgram, ['run', ...wanted, '--json'], { encoding: 'utf8' }));
  const child = spawn(kProgram, ['run', ...wanted, '--studio', '--pace', '4', '--json']);
  let said = '';
  child.stdout.on('data', (data: Buffer) => {
    said += data.toString();
  });
  const viewer = await studio.visit(await urlOf(child));
  await viewer.getByText('started on the command line').waitFor();
  await expect.poll(() => viewer.locator('.run-now b').innerText(), { timeout: 20_000 }).toMatch(/running|done/);
  const refused = await viewer.evaluate(async () => {
    const answer = await fetch('/api/run/stop', { method: 'POST', body: '{}' });
    return `${answer.status} ${(await answer.json()).error.message}`;
  });
  expect(refused).toContain('403 this run belongs to the command line');
  await expect.poll(() => viewer.locator('.run-now b').innerText(), { timeout: 20_000 }).toBe('done');
  await viewer.context().close();
  const ended = new Promise((resolve) => child.once('exit', resolve));
  child.kill('SIGINT');
  await ended;
  expect(said).toContain(digestOf(alone));
});

function digestOf(json: unknown): string {
  const found = JSON.stringify(json).match(/"digest":"([0-9a-f]{16})"/);
  if (!found) throw new Error('no digest');
  return found[1];
}
