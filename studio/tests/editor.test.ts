import { describe, expect, test } from 'vitest';
import type { Kind } from '../src/api/types';
import { keyName } from '../src/commands/keys';
import { signalsOf } from '../src/editor/graph';
import { neighbour } from '../src/editor/keyboard';
import { arrange, arrangeMissing, boxesOf } from '../src/editor/placing';
import { handleOf, inputsOf, outputsOf } from '../src/state/kinds';
import { numberOf } from '../src/text/numbers';
import { component, model, output, wire } from './stub';

const help = { en: '', es: '' };
const port = { unit: '', type: 'real', size: 1, elements: [], required: false, many: false, common: false, help };
const acting: Kind = {
  class: 'acting',
  name: 'K',
  paper_name: '',
  summary: help,
  source: '',
  parameters: [],
  ports: [
    { ...port, name: 'goal', direction: 'in', role: 'request' },
    { ...port, name: 'tracks', direction: 'out', role: 'command', elements: ['left', 'right'] },
    { ...port, name: 'side', direction: 'out', role: 'output' },
  ],
};

describe('ports', () => {
  test('of an acting module begin with its command, which a wire calls by the id alone', () => {
    const one = component('escape', { class: 'acting', outputs: [output('side')] });
    expect(outputsOf(one, acting).map((each) => [each.handle, each.text, each.role])).toEqual([
      ['', 'escape', 'command'],
      ['side', 'escape.side', 'output'],
    ]);
  });

  test('of a module with one output are called by the id, whether the wire names it or not', () => {
    const ports = outputsOf(component('cell', { outputs: [output('cell', ['column', 'row'])] }), undefined);
    expect(ports.map((each) => each.text)).toEqual(['cell']);
    expect([handleOf(ports, ''), handleOf(ports, 'cell')]).toEqual(['', '']);
  });

  test('keep an input that only the file knows', () => {
    const one = component('x', { inputs: [{ port: 'gone', wires: [wire('a')] }] });
    expect(inputsOf(one, acting).map((each) => each.name)).toEqual(['goal', 'gone']);
  });

  test("find a wire's column by output, whole, command, or the only output's name", () => {
    const sensation = component('position', { class: 'sensation', outputs: [output('', ['x', 'y'])] });
    expect(signalsOf(wire('position'), sensation)).toEqual(['position', 'position.command']);
    const cell = component('cell', { outputs: [output('cell')] });
    expect(signalsOf(wire('cell'), cell)).toContain('cell.cell');
    expect(signalsOf(wire('avoid.side@previous'), component('avoid'))[0]).toBe('avoid.side');
  });
});

const chain = model([
  component('a'),
  component('b', { inputs: [{ port: 'in', wires: [wire('a')] }] }),
  component('c', { inputs: [{ port: 'in', wires: [wire('b'), wire('c@previous')] }] }),
  component('d', { inputs: [{ port: 'in', wires: [wire('d')] }] }),
]);

describe('placing', () => {
  const boxes = boxesOf(chain.components, () => 100);

  test('puts what feeds to the left of what is fed', () => {
    const places = arrange(boxes);
    const x = (id: string) => places.get(id)?.[0] ?? Number.NaN;
    expect(x('a')).toBeLessThan(x('b'));
    expect(x('b')).toBeLessThan(x('c'));
  });

  test('lets no two boxes of a column overlap', () => {
    const many = Array.from({ length: 40 }, (_, i) => ({
      id: `n${i}`,
      height: 60 + i,
      from: i > 20 ? ['n0', `n${i - 20}`] : [],
    }));
    const places = arrange(many);
    for (const one of many) {
      for (const other of many) {
        const [[x, y], [ox, oy]] = [places.get(one.id) ?? [0, 0], places.get(other.id) ?? [0, 0]];
        if (one === other || x !== ox || oy < y) continue;
        expect(oy).toBeGreaterThanOrEqual(y + one.height);
      }
    }
  });

  test('leaves what has a place and puts the rest below', () => {
    const places = arrangeMissing(boxes, new Map([['a', [10, 500]]]));
    expect(places.has('a')).toBe(false);
    expect(Math.min(...[...places.values()].map(([, y]) => y))).toBeGreaterThanOrEqual(600);
  });
});

describe('the keyboard', () => {
  test('walks along wires', () => {
    expect(neighbour(chain, 'b', [1, 0])).toBe('c');
    expect(neighbour(chain, 'b', [-1, 0])).toBe('a');
    expect(neighbour(chain, 'b', [0, 1])).toBe('c');
    expect(neighbour(chain, '', [0, 1])).toBe('a');
  });

  test('names keys as the table of commands writes them', () => {
    const none = { ctrlKey: false, metaKey: false, shiftKey: false, altKey: false };
    expect(keyName({ ...none, key: 'z', ctrlKey: true, shiftKey: true })).toBe('Ctrl+Shift+Z');
    expect(keyName({ ...none, key: '?', shiftKey: true })).toBe('?');
    expect(keyName({ ...none, key: ' ' })).toBe('Space');
    expect(keyName({ ...none, key: 'F5', shiftKey: true })).toBe('Shift+F5');
  });

  test('takes a comma for a point and nothing else for a number', () => {
    expect([numberOf('0,5'), numberOf(' -1e-3 '), numberOf(''), numberOf('1 m')]).toEqual([0.5, -0.001, null, null]);
  });
});
