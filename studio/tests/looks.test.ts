import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, test } from 'vitest';
import { en } from '../src/text/en';
import { es } from '../src/text/es';

const kSource = join(import.meta.dirname, '..', 'src');
const colours = readFileSync(join(kSource, 'theme', 'colours.css'), 'utf8');
const kClasses = ['goal', 'sensation', 'sensing', 'acting', 'coordinator'];

type Rgb = [number, number, number];

function variable(theme: 'light' | 'dark', name: string): Rgb {
  const block =
    theme === 'light' ? colours.split('}')[0] : (colours.split('[data-theme="dark"]')[1] ?? '').split('}')[0];
  const hex = block.match(new RegExp(`--${name}: #([0-9a-f]{6})`))?.[1];
  if (!hex) throw new Error(`${theme} has no colour ${name}`);
  return [0, 2, 4].map((at) => Number.parseInt(hex.slice(at, at + 2), 16) / 255) as Rgb;
}

const linear = (c: number) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4);
const luminance = (rgb: Rgb) => rgb.map(linear).reduce((sum, c, i) => sum + c * [0.2126, 0.7152, 0.0722][i], 0);

/** WCAG 2.2, relative luminance and contrast ratio. */
function contrast(a: Rgb, b: Rgb): number {
  const [low, high] = [luminance(a), luminance(b)].sort((x, y) => x - y);
  return (high + 0.05) / (low + 0.05);
}

// Machado, Oliveira, Fernandes (2009), severity 1.0, on linear RGB.
const kVision: Record<string, number[][]> = {
  normal: [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ],
  protan: [
    [0.152286, 1.052583, -0.204868],
    [0.114503, 0.786281, 0.099216],
    [-0.003882, -0.048116, 1.051998],
  ],
  deutan: [
    [0.367322, 0.860646, -0.227968],
    [0.280085, 0.672501, 0.047413],
    [-0.01182, 0.04294, 0.968881],
  ],
  tritan: [
    [1.255528, -0.076749, -0.178779],
    [-0.078411, 0.930809, 0.147602],
    [0.004733, 0.691367, 0.3039],
  ],
};

/** CIE L*a*b* under D65 of a colour as an eye sees it. */
function lab(rgb: Rgb, vision: number[][]): Rgb {
  const lin = rgb.map(linear);
  const [r, g, b] = vision.map((row) =>
    Math.min(
      1,
      Math.max(
        0,
        row.reduce((sum, k, i) => sum + k * lin[i], 0),
      ),
    ),
  );
  const xyz = [
    (0.4124 * r + 0.3576 * g + 0.1805 * b) / 0.95047,
    0.2126 * r + 0.7152 * g + 0.0722 * b,
    (0.0193 * r + 0.1192 * g + 0.9505 * b) / 1.08883,
  ].map((t) => (t > 216 / 24389 ? Math.cbrt(t) : (24389 / 27) * (t / 116) + 16 / 116));
  return [116 * xyz[1] - 16, 500 * (xyz[0] - xyz[1]), 200 * (xyz[1] - xyz[2])];
}

const distance = (a: Rgb, b: Rgb) => Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);

describe.each(['light', 'dark'] as const)('colours, %s', (theme) => {
  test('of classes are told apart by every kind of colour vision', () => {
    for (const vision of Object.values(kVision)) {
      const seen = kClasses.map((name) => lab(variable(theme, name), vision));
      seen.forEach((a, i) => {
        for (const b of seen.slice(i + 1)) expect(distance(a, b)).toBeGreaterThan(20);
      });
    }
  });

  test('of text and classes stand out at 4.5 to 1 on cards', () => {
    for (const name of [...kClasses, 'text', 'muted', 'accent', 'good', 'bad'])
      expect(contrast(variable(theme, name), variable(theme, 'card')), name).toBeGreaterThanOrEqual(4.5);
  });

  test('of text stand out on every ground it lies on', () => {
    for (const ground of ['page', 'picked', 'bad-ground'])
      for (const name of ['text', 'muted'])
        expect(contrast(variable(theme, name), variable(theme, ground)), `${name} on ${ground}`).toBeGreaterThanOrEqual(
          4.5,
        );
    expect(contrast(variable(theme, 'on-accent'), variable(theme, 'accent'))).toBeGreaterThanOrEqual(4.5);
  });
});

function words(dictionary: object, path = ''): [string, string][] {
  return Object.entries(dictionary).flatMap(([key, value]): [string, string][] => {
    if (typeof value === 'function') return [[path + key, value(2, 3)]];
    return typeof value === 'object' ? words(value, `${path}${key}.`) : [[path + key, value]];
  });
}

describe('the dictionaries', () => {
  test('have the same keys', () => {
    expect(words(es).map(([key]) => key)).toEqual(words(en).map(([key]) => key));
  });

  test('say nothing in English in Spanish but names', () => {
    const english = Object.fromEntries(words(en));
    const same = words(es).filter(([key, word]) => /[a-z]{3}/i.test(word) && word === english[key]);
    const alike = ['commands.language', 'new.robot', 'configure.robot', 'world.legend.robot', 'world.legend.sonar'];
    expect(same.map(([key]) => key).filter((key) => !alike.includes(key))).toEqual([]);
  });
});

test('the page holds no list of kinds', () => {
  const files = readdirSync(kSource, { recursive: true, encoding: 'utf8' }).filter((file) => /\.tsx?$/.test(file));
  const named = files.filter((file) =>
    /AvoidObstacle|HoldHeading|SonarConditioner|ClosingSpeed|'Priority'/.test(
      readFileSync(join(kSource, file), 'utf8'),
    ),
  );
  expect(named).toEqual([]);
});
