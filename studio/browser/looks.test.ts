import { readdirSync, readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { gzipSync } from 'node:zlib';
import type { Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, test } from 'vitest';
import { englishIn } from './english';
import { kLooks, open, Studio, shot } from './studio';

const kAxe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');
const kFirstLoad_bytes = 300_000;

let studio: Studio;
beforeAll(async () => {
  studio = await Studio.start();
});
afterAll(() => studio?.stop());

async function show(page: Page, pane: string): Promise<void> {
  const phone = (page.viewportSize()?.width ?? 0) <= 900;
  const tabs = phone ? '.phone-tabs' : pane === 'add' || pane === 'history' ? '.left .tabs' : '.centre > .tabs';
  const order = phone
    ? ['files', 'add', 'drawing', 'table', 'properties', 'world', 'problems', 'history']
    : tabs === '.left .tabs'
      ? ['files', 'add', 'history']
      : ['drawing', 'table', 'world'];
  await page.locator(`${tabs} button`).nth(order.indexOf(pane)).click();
  await page.waitForTimeout(200);
}

/** axe is handed over by the debugger: the page's own policy rightly refuses scripts put in. */
async function complaints(page: Page): Promise<string[]> {
  await page.evaluate(kAxe);
  return page.evaluate(async () => {
    const axe = (
      window as unknown as { axe: { run(): Promise<{ violations: { id: string; nodes: { html: string }[] }[] }> } }
    ).axe;
    const { violations } = await axe.run();
    return violations.map((one) => `${one.id}: ${one.nodes.map((node) => node.html.slice(0, 140)).join(' | ')}`);
  });
}

/** Controls that lie over each other, or are cut off by their own box. */
async function overlaps(page: Page): Promise<string[]> {
  return page.evaluate(() => {
    const seen = [...document.querySelectorAll<HTMLElement>('button, select, input, a, h1, h2, h3')].filter((one) => {
      if (!one.checkVisibility({ visibilityProperty: true })) return false;
      return !one.closest('.canvas, .world-tools, .for-readers, .skip, .scroll, .table-view, .world-about, .toasts');
    });
    const found: string[] = [];
    for (const [i, a] of seen.entries()) {
      const one = a.getBoundingClientRect();
      if (one.right > innerWidth + 1 && !a.closest('.phone-tabs'))
        found.push(`${a.outerHTML.slice(0, 80)} leaves the page`);
      for (const b of seen.slice(i + 1)) {
        if (a.contains(b) || b.contains(a)) continue;
        const two = b.getBoundingClientRect();
        const across = Math.min(one.right, two.right) - Math.max(one.left, two.left);
        const down = Math.min(one.bottom, two.bottom) - Math.max(one.top, two.top);
        if (across > 1 && down > 1) found.push(`${a.outerHTML.slice(0, 80)} over ${b.outerHTML.slice(0, 80)}`);
      }
    }
    return found;
  });
}

/** Targets of less than 24 px that stand in the page's own controls. */
async function smallTargets(page: Page): Promise<string[]> {
  return page.evaluate(() =>
    [...document.querySelectorAll<HTMLElement>('button, select, input')]
      .filter((one) => one.checkVisibility() && !one.closest('.react-flow__viewport, label'))
      .filter((one) => one.getBoundingClientRect().height < 24 && (one as HTMLInputElement).type !== 'range')
      .map((one) => one.outerHTML.slice(0, 100)),
  );
}

const kPanes = ['drawing', 'table', 'world', 'add', 'history'];

describe.each(kLooks)('in $name', ({ name, options }) => {
  test('every pane is whole: axe finds nothing, nothing overlaps, targets are large enough', async () => {
    const page = await studio.page(options);
    await open(page, 'nimrod/controller.toml');
    for (const pane of kPanes) {
      await show(page, pane);
      await shot(page, `${name}_${pane}`);
      expect(await complaints(page), pane).toEqual([]);
      expect(await overlaps(page), pane).toEqual([]);
      expect(await smallTargets(page), pane).toEqual([]);
    }
    await page.context().close();
  });
});

test('at 900 pixels nothing overlaps either', async () => {
  const page = await studio.page({ viewport: { width: 900, height: 700 }, locale: 'es' });
  await open(page, 'pathfinder/controller.toml');
  expect(await overlaps(page)).toEqual([]);
  await shot(page, 'narrow');
  await page.context().close();
});

test('Spanish shows no English words', async () => {
  const page = await studio.page(kLooks[2].options);
  await open(page, 'nimrod/controller.toml');
  // Files have names of their own, in whatever language their authors speak.
  for (const pane of ['add', 'drawing', 'table', 'world', 'history']) {
    await show(page, pane);
    await page.locator('body').click({ position: { x: 640, y: 60 } });
    expect(await englishIn(page), pane).toEqual([]);
  }
  await page.context().close();
});

test('the first load stays below 300 kB', () => {
  const dist = process.env.GANGLION_WEB_ROOT ?? process.env.GANGLION_PAGE ?? join(import.meta.dirname, '..', 'dist');
  const files = readdirSync(dist, { recursive: true, encoding: 'utf8' }).filter((file) =>
    /\.(js|css|html|svg)$/.test(file),
  );
  const bytes = files.reduce((sum, file) => sum + gzipSync(readFileSync(join(dist, file))).length, 0);
  expect(files.length).toBeGreaterThan(2);
  expect(bytes).toBeLessThan(kFirstLoad_bytes);
});
