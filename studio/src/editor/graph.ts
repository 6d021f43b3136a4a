import { type Edge, type Node, Position } from '@xyflow/react';
import type { Component, Model, Problem, Wire } from '../api/types';
import { handleOf, kindOf, outputsOf } from '../state/kinds';
import { isSame } from '../state/share';
import { heightOf, kWidth, type Ports, portsOf, rowMiddle } from './geometry';
import { arrangeMissing, boxesOf, type Point } from './placing';

export interface ComponentData extends Record<string, unknown> {
  component: Component;
  ports: Ports;
  problems: number;
  expanded: boolean;
}

export interface WireData extends Record<string, unknown> {
  wire: Wire;
  port: string;
  /** Which of the port's wires, and of how many. */
  index: number;
  /** What shows its value: `signals` are columns or the beginning of their names, the first that there is counts. */
  signals: string[];
  elements: string[];
  unit: string;
  role: string;
}

export type ComponentNode = Node<ComponentData, 'component'>;
export type WireEdge = Edge<WireData, 'wire'>;

const kHandle = 14;
const kNone: ReadonlySet<string> = new Set();

/** Which outputs of each component are wired somewhere. */
function wiredHandles(model: Model): Map<string, Set<string>> {
  const byId = new Map(model.components.map((component) => [component.id, component]));
  const wired = new Map<string, Set<string>>();
  for (const component of model.components) {
    for (const wire of component.inputs.flatMap((input) => input.wires)) {
      const source = byId.get(wire.from);
      if (!source) continue;
      const handle = handleOf(outputsOf(source, kindOf(source)), wire.output);
      if (!wired.has(wire.from)) wired.set(wire.from, new Set());
      wired.get(wire.from)?.add(handle);
    }
  }
  return wired;
}

function handlesOf(ports: Ports): ComponentNode['handles'] {
  const at = (row: number) => ({ y: rowMiddle(row) - kHandle / 2, width: kHandle, height: kHandle });
  return [
    ...ports.inputs.map((port, row) => ({
      id: `i:${port.name}`,
      type: 'target' as const,
      position: Position.Left,
      x: -kHandle / 2,
      ...at(row),
    })),
    ...ports.outputs.map((port, row) => ({
      id: `o:${port.handle}`,
      type: 'source' as const,
      position: Position.Right,
      x: kWidth - kHandle / 2,
      ...at(row),
    })),
  ];
}

function sameData(a: ComponentData, b: ComponentData): boolean {
  return a.component === b.component && a.problems === b.problems && a.expanded === b.expanded && a.ports === b.ports;
}

export function problemsPer(problems: Problem[]): Map<string, number> {
  const counts = new Map<string, number>();
  for (const problem of problems) counts.set(problem.component, (counts.get(problem.component) ?? 0) + 1);
  return counts;
}

/** Those with an id of their own: a text may name two components alike. */
function drawnOf(model: Model): Component[] {
  const seen = new Set(['']);
  return model.components.filter((component) => !seen.has(component.id) && seen.add(component.id));
}

/** Writes down where each box stands, the file's place or else one that is found for it. */
function settle(drawn: Component[], ports: ReadonlyMap<string, Ports>, places: Map<string, Point>): void {
  for (const one of drawn) if (one.position) places.set(one.id, one.position);
  if (drawn.every((one) => places.has(one.id))) return;
  const boxes = boxesOf(drawn, (one) => heightOf(ports.get(one.id) as Ports));
  for (const [id, at] of arrangeMissing(boxes, places)) places.set(id, at);
}

function nodeOf(data: ComponentData, [x, y]: Point, selected: boolean, node: ComponentNode | undefined): ComponentNode {
  const same = node !== undefined && sameData(node.data, data);
  if (same && node.position.x === x && node.position.y === y && node.selected === selected) return node;
  const samePorts = node?.data.ports === data.ports;
  return {
    ...(node?.measured ? { measured: node.measured } : {}), // without it nothing fits: it comes anew only with a new size
    id: data.component.id,
    type: 'component',
    position: { x, y },
    selected,
    data: same ? node.data : data,
    initialWidth: kWidth,
    initialHeight: heightOf(data.ports),
    handles: samePorts ? node?.handles : handlesOf(data.ports),
    deletable: false,
  };
}

/** The list that was, where it is the same one by one: what looks at it has nothing to do then. */
function unlessSame<T>(before: T[], made: T[]): T[] {
  return made.length === before.length && made.every((one, i) => one === before[i]) ? before : made;
}

/** The drawing's boxes. Those of `before` that did not change are kept as they are; `places` keeps where boxes without
 *  a place in the file were put. */
export function nodesOf(
  model: Model,
  expanded: ReadonlySet<string>,
  selection: readonly string[],
  before: ComponentNode[],
  places: Map<string, Point>,
): ComponentNode[] {
  const wired = wiredHandles(model);
  const counts = problemsPer(model.problems);
  const old = new Map(before.map((node) => [node.id, node]));
  const selected = new Set(selection);
  const drawn = drawnOf(model);
  const ports = new Map(drawn.map((one) => [one.id, portsOf(one, wired.get(one.id) ?? kNone, expanded.has(one.id))]));
  settle(drawn, ports, places);
  const made = drawn.map((component) => {
    const { id } = component;
    const data: ComponentData = {
      component,
      ports: ports.get(id) as Ports,
      problems: counts.get(id) ?? 0,
      expanded: expanded.has(id),
    };
    return nodeOf(data, places.get(id) ?? [0, 0], selected.has(id), old.get(id));
  });
  return unlessSame(before, made);
}

/** Columns of a recorded row that may show a wire's value: the first that there is counts. */
export function signalsOf(wire: Wire, source: Component): string[] {
  const tail = wire.element ? `.${wire.element}` : '';
  if (wire.output) return [`${wire.from}.${wire.output}${tail}`, `${wire.from}${tail}`];
  const only = outputsOf(source, kindOf(source)).find((port) => port.handle === '');
  const names = [`${wire.from}${tail}`, `${wire.from}.command${tail}`];
  return only?.label ? [...names, `${wire.from}.${only.label}${tail}`] : names;
}

/** What an edge was made from: the wire alone does not tell when its source has become another kind. */
const sources = new WeakMap<WireEdge, Component>();

function edgeOf(component: Component, port: string, wire: Wire, index: number, source: Component): WireEdge {
  const outputs = outputsOf(source, kindOf(source));
  const handle = handleOf(outputs, wire.output);
  const from = outputs.find((one) => one.handle === handle);
  return {
    id: `${component.id}|${port}|${wire.text}`,
    type: 'wire',
    source: wire.from,
    sourceHandle: `o:${handle}`,
    target: component.id,
    targetHandle: `i:${port}`,
    data: {
      wire,
      port,
      index,
      signals: signalsOf(wire, source),
      elements: wire.element ? [] : (from?.elements ?? []),
      unit: from?.unit ?? '',
      role: from?.role ?? 'output',
    },
    ariaLabel: `${wire.text} → ${component.id}.${port}`,
    deletable: false,
    focusable: false,
  };
}

function sameEdge(a: WireEdge, b: WireEdge): boolean {
  return a.id === b.id && a.sourceHandle === b.sourceHandle && isSame(a.data, b.data);
}

/** The drawing's wires. Those of `before` that did not change are kept as they are. */
export function edgesOf(model: Model, before: WireEdge[]): WireEdge[] {
  const byId = new Map(model.components.map((component) => [component.id, component]));
  const old = new Map(before.map((edge) => [edge.data?.wire, edge]));
  const selected = new Set(before.filter((edge) => edge.selected).map((edge) => edge.id));
  const made: WireEdge[] = [];
  for (const component of model.components) {
    for (const input of component.inputs) {
      input.wires.forEach((wire, index) => {
        const source = byId.get(wire.from);
        if (!source) return;
        const kept = old.get(wire);
        const fits = kept?.target === component.id && kept.data?.port === input.port && kept.data.index === index;
        if (kept && fits && sources.get(kept) === source) {
          made.push(kept);
          return;
        }
        const edge = edgeOf(component, input.port, wire, index, source);
        const same = kept !== undefined && sameEdge(kept, edge);
        if (!same && selected.has(edge.id)) edge.selected = true;
        sources.set(same ? kept : edge, source);
        made.push(same ? kept : edge);
      });
    }
  }
  return unlessSame(before, made);
}
