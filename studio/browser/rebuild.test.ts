import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { afterAll, beforeAll, describe, expect, onTestFailed, test } from 'vitest';
import { build, kNimrod, kPathfinder } from './build';
import { kKeyboard, kMouse } from './hands';
import { kLooks, Studio, shot } from './studio';
import { plain } from './toml';

let studio: Studio;
beforeAll(async () => {
  studio = await Studio.start();
});
afterAll(() => studio?.stop());

describe.each([
  ['mouse', kMouse],
  ['keyboard', kKeyboard],
] as const)('with the %s alone', (hand, way) => {
  test.each([
    ['pathfinder', kPathfinder],
    ['nimrod', kNimrod],
  ] as const)(
    'the shipped %s is rebuilt from an empty drawing',
    async (folder, plan) => {
      const page = await studio.page({ ...kLooks[0].options, viewport: { width: 1600, height: 1000 } });
      onTestFailed(() => shot(page, `failed_${folder}_${hand}`));
      const file = `${plan.file}_${hand}`;
      await build(page, { ...plan, file }, way);
      await shot(page, `rebuilt_${folder}_${hand}`);
      const built = plain(readFileSync(join(studio.folder, folder, `${file}.toml`), 'utf8'));
      expect(built).toEqual(plain(readFileSync(join(studio.folder, folder, 'controller.toml'), 'utf8')));
      expect(await page.locator('.problems-head').innerText()).toBe('No problems');
      await page.context().close();
    },
    120_000,
  );
});
