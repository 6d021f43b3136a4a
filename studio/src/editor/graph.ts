import { type Edge, type Node, Position } from '@xyflow/react';
import type { Component, Model, Problem, Wire } from '../api/types';
import { handleOf, kindOf, outputsOf } from '../document/kinds';
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
  return (
    a.component === b.component &&
    a.problems === b.problems &&
    a.expanded === b.expanded &&
    a.ports.outputs.length === b.ports.outputs.length &&
    a.ports.outputs.every((port, i) => port.handle === b.ports.outputs[i].handle)
  );
}

function problemsPer(problems: Problem[]): Map<string, number> {
  const counts = new Map<string, number>();
  for (const problem of problems) counts.set(problem.component, (counts.get(problem.component) ?? 0) + 1);
  return counts;
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
  const drawn = model.components.filter(
    (component, i, all) => component.id !== '' && all.findIndex((one) => one.id === component.id) === i,
  );
  const ports = new Map(drawn.map((one) => [one.id, portsOf(one, wired.get(one.id) ?? kNone, expanded.has(one.id))]));
  for (const one of drawn) if (one.position) places.set(one.id, one.position);
  const boxes = boxesOf(drawn, (one) => heightOf(ports.get(one.id) as Ports));
  for (const [id, at] of arrangeMissing(boxes, places)) places.set(id, at);
  return drawn.map((component) => {
    const [x, y] = places.get(component.id) ?? [0, 0];
    const made: ComponentData = {
      component,
      ports: ports.get(component.id) as Ports,
      problems: counts.get(component.id) ?? 0,
      expanded: expanded.has(component.id),
    };
    const node = old.get(component.id);
    const same = node && sameData(node.data, made);
    const isSelected = selected.has(component.id);
    if (same && node.position.x === x && node.position.y === y && node.selected === isSelected) return node;
    return {
      ...(node?.measured && same ? { measured: node.measured } : {}),
      id: component.id,
      type: 'component',
      position: { x, y },
      selected: isSelected,
      data: same ? node.data : made,
      initialWidth: kWidth,
      initialHeight: heightOf(made.ports),
      handles: handlesOf(made.ports),
      deletable: false,
    };
  });
}

/** Columns of a recorded row that may show a wire's value: the first that there is counts. */
export function signalsOf(wire: Wire, source: Component): string[] {
  const tail = wire.element ? `.${wire.element}` : '';
  if (wire.output) return [`${wire.from}.${wire.output}${tail}`, `${wire.from}${tail}`];
  const only = outputsOf(source, kindOf(source)).find((port) => port.handle === '');
  const names = [`${wire.from}${tail}`, `${wire.from}.command${tail}`];
  return only?.label ? [...names, `${wire.from}.${only.label}${tail}`] : names;
}

export function edgesOf(model: Model, before: WireEdge[]): WireEdge[] {
  const byId = new Map(model.components.map((component) => [component.id, component]));
  const old = new Map(before.map((edge) => [edge.id, edge]));
  const edges: WireEdge[] = [];
  for (const component of model.components) {
    for (const input of component.inputs) {
      input.wires.forEach((wire, index) => {
        const source = byId.get(wire.from);
        if (!source) return;
        const id = `${component.id}|${input.port}|${wire.text}`;
        const kept = old.get(id);
        if (kept?.data?.wire === wire && kept.data.index === index) {
          edges.push(kept);
          return;
        }
        const outputs = outputsOf(source, kindOf(source));
        const handle = handleOf(outputs, wire.output);
        const port = outputs.find((one) => one.handle === handle);
        edges.push({
          id,
          type: 'wire',
          source: wire.from,
          sourceHandle: `o:${handle}`,
          target: component.id,
          targetHandle: `i:${input.port}`,
          data: {
            wire,
            port: input.port,
            index,
            signals: signalsOf(wire, source),
            elements: wire.element ? [] : (port?.elements ?? []),
            unit: port?.unit ?? '',
            role: port?.role ?? 'output',
          },
          ariaLabel: `${wire.text} → ${component.id}.${input.port}`,
          selected: kept?.selected,
          deletable: false,
          focusable: false,
        });
      });
    }
  }
  return edges;
}
