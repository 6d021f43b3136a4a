import { describe, expect, test } from 'vitest';
import { decodeMessage, decodeSample, decodeSamples } from '../src/api/samples';
import type { Stream } from '../src/api/types';
import { FieldTrack } from '../src/state/field_track';
import { frameAt, shapesAt } from '../src/state/frames';
import { indexAt, RowTrack } from '../src/state/rows';
import { Timeline } from '../src/state/timeline';
import { candidatesAt } from '../src/world/drives';

const row: Stream = {
  stream: 1,
  topic: '/robot0/signals',
  kind: 'row',
  columns: ['arbiter.active', 'arbiter.suppressed.hold', 'x'].map((name) => ({ name, unit: '' })),
};
const whose = { robot: 0, owner: 'router', form: 'field', name: 'map' };
const field: Stream = { stream: 2, topic: '/robot0/exhibit/router/field/map', kind: 'field', columns: [], of: whose };
const words = { title: { en: 'Map', es: 'Mapa' }, frame: 'world', cell: [0.25, 0.25], layers: [] };

/** Written down byte by byte from docs/studio_api.md. */
function bytes(kind: number, stream: number, seq: number, t: number, payload: [string, number][]): ArrayBuffer {
  const sizes: Record<string, number> = { u8: 1, u32: 4, f64: 8 };
  const buffer = new ArrayBuffer(16 + payload.reduce((sum, [type]) => sum + sizes[type], 0));
  const view = new DataView(buffer);
  view.setUint8(0, kind);
  view.setUint8(1, 1);
  view.setUint16(2, stream, true);
  view.setUint32(4, seq, true);
  view.setFloat64(8, t, true);
  let at = 16;
  for (const [type, value] of payload) {
    if (type === 'u8') view.setUint8(at, value);
    else if (type === 'u32') view.setUint32(at, value, true);
    else view.setFloat64(at, value, true);
    at += sizes[type];
  }
  return buffer;
}

function rowAt(t: number, values: number[]): ArrayBuffer {
  return bytes(1, 1, 0, t, [['u32', 7], ['u32', values.length], ...values.map((v): [string, number] => ['f64', v])]);
}

function fieldAt(t: number, base: number, cells: [number, number, number][]): ArrayBuffer {
  const text = base === 0 ? new TextEncoder().encode(JSON.stringify(words)) : new Uint8Array();
  const head: [string, number][] = [
    ['u32', base],
    ['u32', 2],
    ['u32', 3],
    ['f64', -1],
    ['f64', 0.5],
    ['u32', 2],
    ['u32', cells.length],
    ['u32', text.length],
  ];
  const ids = cells.map(([cell]): [string, number] => ['u32', cell]);
  const values = cells.flatMap(([, a, b]): [string, number][] => [
    ['u8', a],
    ['u8', b],
  ]);
  return bytes(6, 2, 1, t, [...head, ...ids, ...values, ...[...text].map((byte): [string, number] => ['u8', byte])]);
}

const sample = (buffer: ArrayBuffer) => {
  const decoded = decodeSample(new DataView(buffer));
  if (!decoded) throw new Error('not understood');
  return decoded;
};

describe('a sample', () => {
  test('of a row keeps what is no number', () => {
    const decoded = sample(rowAt(2.5, [1, Number.NaN, Number.POSITIVE_INFINITY]));
    expect(decoded).toMatchObject({ kind: 'row', stream: 1, t: 2.5, tick: 7 });
    expect([...(decoded.kind === 'row' ? decoded.values : [])]).toEqual([1, Number.NaN, Number.POSITIVE_INFINITY]);
  });

  test('that is cut short or of another version is left out', () => {
    const whole = rowAt(1, [1, 2]);
    expect(decodeSample(new DataView(whole, 0, whole.byteLength - 1))).toBeNull();
    new DataView(whole).setUint8(1, 2);
    expect(decodeSample(new DataView(whole))).toBeNull();
  });

  test('stands behind its length in a recording', () => {
    const one = new Uint8Array(rowAt(1, [4]));
    const file = new Uint8Array(2 * (one.length + 4) - 1);
    new DataView(file.buffer).setUint32(0, one.length, true);
    file.set(one, 4);
    new DataView(file.buffer).setUint32(one.length + 4, one.length, true);
    expect(decodeSamples(file.buffer)).toHaveLength(1);
  });

  test('comes alone or bundled with others', () => {
    const one = new Uint8Array(rowAt(1, [4]));
    const other = new Uint8Array(rowAt(2, [5, 6]));
    expect(decodeMessage(rowAt(3, [1]))).toHaveLength(1);
    const bundle = new Uint8Array(16 + 8 + one.length + 8 + other.length);
    bundle.set([5, 1]);
    const view = new DataView(bundle.buffer);
    view.setUint32(16, one.length, true);
    bundle.set(one, 24);
    view.setUint32(24 + one.length, other.length, true);
    bundle.set(other, 32 + one.length);
    const rows = decodeMessage(bundle.buffer).map((each) => [each.t, ...(each.kind === 'row' ? each.values : [])]);
    expect(rows).toEqual([
      [1, 4],
      [2, 5, 6],
    ]);
    expect(decodeMessage(bundle.buffer.slice(0, -1))).toHaveLength(1);
  });
});

describe('a timeline', () => {
  test('finds the last entry not later than a time', () => {
    expect([-1, 0, 0.9, 1, 9].map((t) => indexAt([0, 1, 2], t))).toEqual([-1, 0, 0, 1, 2]);
  });

  test('shows a field as it was, forwards and backwards', () => {
    const timeline = new Timeline([row, field], null, null);
    timeline.add(sample(fieldAt(1, 0, [[0, 10, 11]])));
    timeline.add(sample(fieldAt(2, 1, [[5, 20, 21]])));
    timeline.add(sample(fieldAt(3, 0, [[1, 30, 31]])));
    timeline.add(
      sample(
        fieldAt(4, 1, [
          [1, 40, 41],
          [2, 50, 51],
        ]),
      ),
    );
    const values = (t: number) => [...(timeline.fields[0].track.at(t)?.values ?? [])];
    const unknown = Array.from({ length: 8 }, () => 255);
    const at1 = [10, 11, ...unknown, 255, 255];
    const at2 = [10, 11, ...unknown, 20, 21];
    const at4 = [255, 255, 40, 41, 50, 51, ...unknown.slice(2)];
    expect(values(4)).toEqual(at4);
    expect(values(2)).toEqual(at2);
    expect(values(1)).toEqual(at1);
    expect(values(2.5)).toEqual(at2);
    expect(values(0.5)).toEqual([]);
    expect(values(9)).toEqual(at4);
  });

  test('keeps the newest as it came and goes back to the beginning in coarser steps', () => {
    const bytesOfRow = 8 * 4;
    const track = new RowTrack(row, 100 * bytesOfRow);
    for (let i = 0; i < 10_000; i += 1) track.add(i, Float64Array.of(0, 0, i));
    expect(track.length).toBeLessThanOrEqual(100);
    expect(track.value(0, 2)).toBe(0);
    expect([9_999, 9_998, 9_997].map((t) => track.value(track.at(t), 2))).toEqual([9_999, 9_998, 9_997]);
    const seen = Array.from({ length: track.length }, (_, i) => track.value(i, 2));
    expect(seen).toEqual(track.times);
  });

  test('knows of columns that are not kept only the newest value', () => {
    const track = new RowTrack(row, 1 << 20, (name) => name === 'x');
    track.add(1, Float64Array.of(5, 6, 7));
    track.add(2, Float64Array.of(8, 9, 10));
    expect([0, 1, 2].map((column) => track.value(1, column))).toEqual([8, 9, 10]);
    expect([0, 1, 2].map((column) => track.value(0, column))).toEqual([Number.NaN, Number.NaN, 7]);
  });

  test('folds the older half of a field that changed too often', () => {
    const track = new FieldTrack(100 * 300);
    const add = (t: number, base: number, cells: [number, number, number][]) => {
      const change = sample(fieldAt(t, base, cells));
      if (change.kind === 'field') track.add(t, change.base, change.field);
    };
    add(0, 0, [[0, 1, 2]]);
    for (let i = 1; i < 1000; i += 1) add(i, i, [[1 + (i % 5), i % 251, 9]]);
    const value = (t: number, cell: number) => track.at(t)?.values[2 * cell];
    expect([value(999, 0), value(999, 1 + (999 % 5)), value(992, 1 + (992 % 5))]).toEqual([1, 999 % 251, 992 % 251]);
    expect(value(0, 0)).toBe(1);
    expect(value(0, 1)).toBeLessThan(255); // what was before is shown as it was folded
  });

  test('places shapes in frames that columns lead, and tells a radius by its signal', () => {
    const of = (form: string, name: string) => ({ robot: 0, owner: 'all', form, name });
    const stream = (n: number, form: string, name: string): Stream => ({
      stream: n,
      topic: `/robot0/exhibit/all/${form}/${name}`,
      kind: 'exhibit',
      columns: [],
      of: of(form, name),
    });
    const streams = [row, stream(3, 'frame', 'nose'), stream(4, 'frame', 'mast'), stream(5, 'marks', 'marks')];
    const timeline = new Timeline(streams, null, null);
    const title = { en: '', es: '' };
    const told = (n: number, exhibit: object) =>
      timeline.add({ stream: n, seq: 1, t: 0, kind: 'exhibit', exhibit: { title, ...exhibit } });
    timeline.add(sample(rowAt(0, [2, 0, Math.PI / 2])));
    told(3, { in: 'world', x: 1, y: 0, yaw: 0, columns: ['arbiter.active', '', 'x'] });
    told(4, { in: 'nose', x: 0.5, y: 0, yaw: 0, columns: ['', '', ''] });
    told(5, { shapes: [{ form: 3, role: 'echo', frame: 'mast', xy: [0, 0], column: 'arbiter.active' }] });
    const [placed] = shapesAt(timeline, 0, 0);
    expect(placed.radius).toBe(2);
    expect(placed.pose.x).toBeCloseTo(3); // 1 + 2 along x, then half a metre along the turned frame
    expect(placed.pose.y).toBeCloseTo(0.5);
    expect(placed.pose.yaw).toBeCloseTo(Math.PI / 2);
    expect(shapesAt(timeline, 1, 0)).toEqual([]);
    expect(frameAt(timeline, of('marks', 'marks'), 'nowhere', 0)).toBeNull();
  });

  test('tells who drives and who is suppressed', () => {
    const info = { robots: [], coordinators: [{ id: 'arbiter', candidates: ['escape', 'hold'] }], cell_m: 0 };
    const timeline = new Timeline([row], null, info);
    timeline.add(sample(rowAt(0, [0, 1, 0])));
    timeline.add(sample(rowAt(1, [1, 0, 0])));
    const states = (t: number) => candidatesAt(timeline, 0, t).map((one) => one.state);
    expect(states(0)).toEqual(['driving', 'suppressed']);
    expect(states(1)).toEqual(['silent', 'driving']);
  });
});

test('a run of which ticks are missing is told from a whole one', () => {
  const timeline = new Timeline([row], null, null);
  expect(timeline.isWhole(0)).toBe(false);
  for (const t of [0, 0.5, 1, 1.5, 9.5]) timeline.add(sample(rowAt(t, [0, 0, 0])));
  expect(timeline.isWhole(2)).toBe(true);
  expect(timeline.isWhole(10)).toBe(false);
  expect(timeline.bytesOf(10)).toBe(20 * 3 * 8);
});
