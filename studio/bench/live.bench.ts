// A run of a hundred robots, watched: sixty components with a value on every wire, at thirty ticks a second.
import type { CDPSession, Page } from 'playwright-core';
import { afterAll, beforeAll, expect, test } from 'vitest';
import { open, Studio } from '../browser/studio';
import type { RunState } from '../src/api/types';
import { cpu_s, favour, resident_MiB, trend } from './processes';
import { atLeast, printRows, row } from './rows';
import { kComponents, writeSwarm } from './swarm';
import { ask, Viewer } from './viewer';

const kRobots = 100;
const kLong_s = 60 * Number(process.env.GANGLION_BENCH_MINUTES ?? 10);
const kSample_s = 10;
const kSettled_s = 60;
const kUpdatesBar = 28;
const kFramesBar = 50;
/** Of a memory that does not grow: so much more or less after nine minutes is the weather. */
const kFlat_share = 0.05;

let studio: Studio;
let page: Page;
let session: CDPSession;
let controller = '';

beforeAll(async () => {
  studio = await Studio.start();
  controller = writeSwarm(studio.folder, kRobots, 3600);
});
afterAll(async () => {
  printRows();
  await studio?.stop();
});

const pause = (s: number) => new Promise((resolve) => setTimeout(resolve, 1000 * s));
const runState = () => ask<RunState>(studio.url, '/api/run');

interface Seen {
  frames: number;
  updates: number;
}

async function countSeen(): Promise<void> {
  await page.evaluate(() => {
    const seen = { frames: 0, updates: 0 };
    (window as unknown as { seen: Seen }).seen = seen;
    const frame = () => {
      seen.frames += 1;
      requestAnimationFrame(frame);
    };
    requestAnimationFrame(frame);
    // All labels of one update are written in one go, and told of in one.
    const observer = new MutationObserver((changes) => {
      const labels = changes.some((one) => (one.target as Element).classList?.contains('wire-value'));
      seen.updates += labels ? 1 : 0;
    });
    observer.observe(document.body, { subtree: true, childList: true });
  });
}

async function metrics(): Promise<Map<string, number>> {
  const { metrics: list } = await session.send('Performance.getMetrics');
  return new Map(list.map((one) => [one.name, one.value]));
}

test('values and frames keep up', async () => {
  page = await studio.page();
  session = await page.context().newCDPSession(page);
  await session.send('Performance.enable', { timeDomain: 'threadTicks' });
  await open(page, controller);
  expect(await page.locator('.box').count()).toBe(kComponents);
  // A run file is limited to 4 GiB unpacked, which this run fills in seven minutes.
  await page.getByRole('button', { name: 'Configure…' }).click();
  await page.getByRole('dialog').getByLabel('Record the run').uncheck();
  await page.getByRole('dialog').getByRole('button', { name: 'Done' }).click();
  await page.locator('.canvas').focus();
  await page.keyboard.press('F5');
  await page.locator('.wire-value:visible').first().waitFor();
  await countSeen();
  await pause(10);
  favour([...(await studio.browserPids()), studio.pid]);
  const labels = await page.locator('.wire-value:visible').count();
  const wires = await page.locator('.react-flow__edge').count();
  const look = async () => ({
    at: performance.now() / 1000,
    seen: await page.evaluate(() => ({ ...(window as unknown as { seen: Seen }).seen })),
    busy: (await metrics()).get('TaskDuration') ?? 0,
    server: cpu_s(studio.pid),
    time_s: (await runState()).time_s,
  });
  const before = await look();
  await pause(30);
  const after = await look();
  const wall = after.at - before.at;
  row(`live: ${kRobots} robots, ${kComponents} components, values on ${labels} of ${wires} wires`, '');
  atLeast('live: updates of the values', (after.seen.updates - before.seen.updates) / wall, kUpdatesBar, '/s', 1);
  atLeast('live: frames', (after.seen.frames - before.seen.frames) / wall, kFramesBar, '/s', 1);
  row('live: main thread at work', `${((100 * (after.busy - before.busy)) / wall).toFixed(0)} %`);
  row('live: server at work, of one core', `${((100 * (after.server - before.server)) / wall).toFixed(0)} %`);
  row('live: times real time', ((after.time_s - before.time_s) / wall).toFixed(3));
  if (process.env.GANGLION_BENCH_SHOT) await page.screenshot({ path: process.env.GANGLION_BENCH_SHOT });
});

test(
  'memory stays as it is',
  async () => {
    const [pagePid] = await studio.browserPids();
    const taken: { t: number; heap: number; page: number; server: number }[] = [];
    const begun = performance.now() / 1000;
    for (let t = 0; t <= kLong_s; t = performance.now() / 1000 - begun) {
      await session.send('HeapProfiler.collectGarbage');
      const heap = ((await metrics()).get('JSHeapUsedSize') ?? 0) / (1 << 20);
      taken.push({ t, heap, page: resident_MiB(pagePid), server: resident_MiB(studio.pid) });
      if (process.env.GANGLION_BENCH_SAMPLES) console.log(JSON.stringify(taken.at(-1)));
      await pause(kSample_s);
    }
    const settled = taken.filter((one) => one.t >= Math.min(kSettled_s, kLong_s / 2));
    for (const what of ['heap', 'page', 'server'] as const) {
      const values = settled.map((one) => one[what]);
      const { rise, change } = trend(
        settled.map((one) => one.t),
        values,
      );
      const name = { heap: "page's heap after collecting", page: "page's process", server: "server's process" }[what];
      row(
        `memory over ${(kLong_s / 60).toFixed(0)} min: ${name}`,
        `${values[0].toFixed(1)} to ${values.at(-1)?.toFixed(1)} MiB, ${(60 * rise).toFixed(2)} MiB/min`,
        `within ${100 * kFlat_share} %`,
        change <= kFlat_share * values[0],
      );
    }
    await page.context().close();
    await ask(studio.url, '/api/run/stop', {});
  },
  1000 * (kLong_s + 120),
);

/** One run of its own, looked at by so many. */
async function watched(viewers: number, pace: number): Promise<void> {
  await expect.poll(async () => (await runState()).state, { timeout: 60_000 }).toMatch(/idle|done/);
  await ask(studio.url, '/api/run/start', { experiment: 'swarm/experiment.toml', pace, record: false });
  const all = await Promise.all(Array.from({ length: viewers }, () => Viewer.come(studio.url)));
  await expect.poll(async () => (await runState()).state, { timeout: 20_000 }).toBe('running');
  await pause(3);
  const bytes = () => all.reduce((sum, one) => sum + one.bytes, 0);
  const look = async () => ({
    at: performance.now() / 1000,
    bytes: bytes(),
    cpu: cpu_s(studio.pid),
    time_s: (await runState()).time_s,
  });
  const before = await look();
  await pause(10);
  const after = await look();
  const wall = after.at - before.at;
  const period_ms = (1000 * wall) / ((after.time_s - before.time_s) * 30);
  const each = viewers > 0 ? `, ${((after.bytes - before.bytes) / wall / viewers / 1e6).toFixed(2)} MB/s each` : '';
  row(
    `hub: ${viewers} viewers, ${pace === 0 ? 'as fast as can be' : 'real time'}`,
    `a tick in ${period_ms.toFixed(2)} ms, server ${((100 * (after.cpu - before.cpu)) / wall).toFixed(0)} %${each}`,
  );
  for (const one of all) one.leave();
  await ask(studio.url, '/api/run/stop', {});
}

test('viewers cost the run little', async () => {
  for (const pace of [1, 0]) for (const viewers of [0, 1, 10]) await watched(viewers, pace);
});
