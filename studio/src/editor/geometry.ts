import type { Component } from '../api/types';
import { type InputPort, inputsOf, kindOf, type OutputPort, outputsOf } from '../state/kinds';

// A box of the drawing [px]. Rows are of one height so that wires can be drawn to boxes that are not.
export const kWidth = 230;
export const kHead = 46;
export const kRow = 24;
export const kFoot = 6;
const kRowsWithoutFold = 4;

/** What of a component is drawn: its inputs, and of its outputs those that matter until it is unfolded. */
export interface Ports {
  inputs: InputPort[];
  outputs: OutputPort[];
  hidden: number;
  foldable: boolean;
}

function matters(port: OutputPort, wired: ReadonlySet<string>): boolean {
  return port.role === 'command' || port.handle === '' || wired.has(port.handle);
}

const portsKnown = new WeakMap<Component, { key: string; ports: Ports }>();

/** The same object as long as nothing of it changes. */
export function portsOf(component: Component, wired: ReadonlySet<string>, expanded: boolean): Ports {
  const key = `${expanded} ${[...wired].sort().join(' ')}`;
  const known = portsKnown.get(component);
  if (known?.key === key) return known.ports;
  const ports = makePorts(component, wired, expanded);
  portsKnown.set(component, { key, ports });
  return ports;
}

function makePorts(component: Component, wired: ReadonlySet<string>, expanded: boolean): Ports {
  const kind = kindOf(component);
  const inputs = inputsOf(component, kind);
  const all = outputsOf(component, kind);
  const few = all.filter((port) => !port.common || wired.has(port.handle));
  const folded = few.length <= kRowsWithoutFold ? few : few.filter((port) => matters(port, wired));
  const outputs = expanded ? all : folded;
  return { inputs, outputs, hidden: all.length - outputs.length, foldable: all.length - folded.length > 1 };
}

export function heightOf(ports: Ports): number {
  const rows = Math.max(ports.inputs.length, ports.outputs.length + (ports.foldable ? 1 : 0));
  return kHead + rows * kRow + kFoot;
}

/** Where a row's port is, from the box's upper edge. */
export function rowMiddle(row: number): number {
  return kHead + row * kRow + kRow / 2;
}
