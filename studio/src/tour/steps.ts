import type { Model, Operation } from '../api/types';
import type { Dictionary } from '../text/en';

export interface TourStep {
  name: keyof Dictionary['tour']['steps'];
  /** Looked at after every edit: the tour goes on by itself. */
  done(model: Model): boolean;
  /** Carried out by "do it for me", in so far as it is not there yet. */
  operations(model: Model): Operation[];
}

/** Figure 6: the sensations, by the channels of the pathfinder robot. */
const kSensations: [string, string][] = [
  ['goal', 'trainer.goal'],
  ['goal_direction', 'trainer.direction'],
  ['position', 'place.position'],
  ['heading', 'compass.heading'],
  ['contact', 'bumper.contact'],
];

const kRouterWires = ['goal', 'cell', 'position', 'heading', 'contact', 'goal_direction'];

function ofKind(model: Model, kind: string) {
  return model.components.find((component) => component.kind === kind);
}

function bySensation(model: Model, channel: string): string | undefined {
  return model.components.find((component) => component.channel === channel)?.id;
}

function wiresOf(model: Model, kind: string, port: string) {
  return ofKind(model, kind)?.inputs.find((input) => input.port === port)?.wires ?? [];
}

function made(model: Model, cls: string, kind: string, id: string, position: [number, number]): Operation[] {
  return ofKind(model, kind) ? [] : [{ op: 'add', class: cls, kind, id, position }];
}

function wired(model: Model, kind: string, id: string, port: string, from: string | undefined): Operation[] {
  if (from === undefined || wiresOf(model, kind, port).length > 0) return [];
  return [{ op: 'connect', from, id: ofKind(model, kind)?.id ?? id, port }];
}

function routerSource(model: Model, port: string): string | undefined {
  if (port === 'goal') return ofKind(model, 'App')?.id;
  if (port === 'cell') return ofKind(model, 'GridCell')?.id;
  const channel = kSensations.find(([id]) => id === port)?.[1];
  return channel ? bySensation(model, channel) : undefined;
}

export const kTour: TourStep[] = [
  {
    name: 'file',
    done: (model) => model.robot.channels.some((channel) => channel.name === 'trainer.goal'),
    operations: () => [],
  },
  {
    name: 'sensations',
    done: (model) => kSensations.every(([, channel]) => bySensation(model, channel) !== undefined),
    operations: (model) =>
      kSensations.flatMap(([id, channel], i): Operation[] =>
        bySensation(model, channel)
          ? []
          : [{ op: 'add', class: 'sensation', kind: '', id, set: { channel }, position: [0, 110 * i] }],
      ),
  },
  {
    name: 'cell',
    done: (model) => wiresOf(model, 'GridCell', 'position').length > 0,
    operations: (model) => [
      ...made(model, 'sensing', 'GridCell', 'cell', [330, 180]),
      ...wired(model, 'GridCell', 'cell', 'position', bySensation(model, 'place.position')),
    ],
  },
  {
    name: 'app',
    done: (model) => wiresOf(model, 'App', 'request').length > 0,
    operations: (model) => [
      ...made(model, 'goal', 'App', 'app', [330, 0]),
      ...wired(model, 'App', 'app', 'request', bySensation(model, 'trainer.goal')),
    ],
  },
  {
    name: 'router',
    done: (model) => ofKind(model, 'DynamicMapRouter') !== undefined,
    operations: (model) => made(model, 'acting', 'DynamicMapRouter', 'router', [680, 120]),
  },
  {
    name: 'wires',
    done: (model) => kRouterWires.every((port) => wiresOf(model, 'DynamicMapRouter', port).length > 0),
    operations: (model) =>
      kRouterWires.flatMap((port) => wired(model, 'DynamicMapRouter', 'router', port, routerSource(model, port))),
  },
  {
    name: 'command',
    done: (model) => ofKind(model, 'DynamicMapRouter')?.command !== '' && model.runnable,
    operations: (model) => {
      const id = ofKind(model, 'DynamicMapRouter')?.id;
      return id ? [{ op: 'set', id, key: 'command', value: 'step' }] : [];
    },
  },
  { name: 'run', done: () => false, operations: () => [] },
];
