import { describe, expect, test } from 'vitest';
import type { Info, InterventionEvent, Scene } from '../src/api/types';
import { Timeline } from '../src/state/timeline';
import { en } from '../src/text/en';
import { es } from '../src/text/es';
import { cellAt, goalCell_m, interventionWords, moverAt } from '../src/world/reach';
import { View } from '../src/world/view';

const corners: [number, number][] = [
  [-0.5, -0.1],
  [0.5, -0.1],
  [0.5, 0.1],
  [-0.5, 0.1],
];
const scene: Scene = {
  name: 'w',
  bounds: [0, 0, 10, 10],
  shapes: [],
  spawns: [],
  movers: [
    { class: 'mover', id: 'bar', points: corners, pose: [2, 2, Math.PI / 2] },
    { class: 'mover', id: 'person', radius: 0.25, pose: [5, 5, 0] },
  ],
};
const sensor = { x_m: 0, y_m: 0, yaw_rad: 0, cone_rad: 0, max_range_m: 0, signal: '' };
const info: Info = {
  robots: [
    { name: 'a', length_m: 1, width_m: 1, radius_m: 1, sensors: [{ ...sensor, id: 's', kind: 'Sonar' }] },
    {
      name: 'b',
      length_m: 1,
      width_m: 1,
      radius_m: 1,
      sensors: [],
      goal_cell_m: 0.5,
    },
  ],
  coordinators: [],
  cell_m: 0.2,
};

describe('what a pointer finds', () => {
  const timeline = new Timeline([{ stream: 9, topic: '/movers', kind: 'movers', columns: [] }], scene, info);

  test('an obstacle is found where it stands, turned as it is', () => {
    expect(moverAt(timeline, 0, [2.05, 2.4])?.id).toBe('bar');
    expect(moverAt(timeline, 0, [2.4, 2.05])).toBeUndefined();
    expect(moverAt(timeline, 0, [5.2, 5.1])?.id).toBe('person');
  });

  test('a finger may be a little beside it', () => {
    expect(moverAt(timeline, 0, [5.3, 5])).toBeUndefined();
    expect(moverAt(timeline, 0, [5.3, 5], 0.1)?.id).toBe('person');
  });

  test('it is found where it has moved to, at that time', () => {
    const movers = [{ id: 'person', x_m: 8, y_m: 1, yaw_rad: 0 }];
    timeline.add({ stream: 9, seq: 1, t: 3, kind: 'movers', movers });
    expect(moverAt(timeline, 3, [8, 1])?.id).toBe('person');
    expect(moverAt(timeline, 3, [5, 5])).toBeUndefined();
    expect(moverAt(timeline, 2, [5, 5])?.id).toBe('person');
  });

  test('cells are those of who takes goals; a robot without one has none', () => {
    expect(goalCell_m(timeline, 0)).toBeNull();
    expect(goalCell_m(timeline, 1)).toBe(0.5);
    expect(goalCell_m(timeline, 2)).toBeNull();
    expect(cellAt([1.74, -0.01], 0.5)).toEqual([1.5, -0.5, 0.5]);
  });
});

test('what was done shows at once, before the tick it counts for', () => {
  const timeline = new Timeline([], scene, info);
  const done: InterventionEvent = {
    event: 'intervention',
    time_s: 4,
    tick: 4,
    what: 'goal',
    robot: 1,
    x_m: 2.346,
    y_m: 9,
  };
  timeline.addEvent(done);
  expect(timeline.end).toBe(4);
  expect(interventionWords(done, en)).toBe('by hand: goal at 2.35, 9.00');
  expect(interventionWords({ ...done, what: 'obstacle', mover: 'crate' }, es)).toBe('a mano: crate a 2.35, 9.00');
});

test('a point of the canvas is the point of the world drawn there', () => {
  const view = new View({} as HTMLCanvasElement);
  view.scale = 40;
  view.middle = [300, 200];
  view.centre = [6, 5];
  const [x, y] = view.metres(view.x(1.25), view.y(8.5));
  expect(x).toBeCloseTo(1.25, 12);
  expect(y).toBeCloseTo(8.5, 12);
});
