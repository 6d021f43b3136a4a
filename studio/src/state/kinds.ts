import { create } from 'zustand';
import { api } from '../api/client';
import type { Component, Kind, Output, PortDescriptor } from '../api/types';

interface Kinds {
  list: Kind[];
  byName: Map<string, Kind>;
}

export const useKinds = create<Kinds>(() => ({ list: [], byName: new Map() }));

export async function loadKinds(): Promise<void> {
  const list = await api.kinds();
  useKinds.setState({ list, byName: new Map(list.map((kind) => [`${kind.class}/${kind.name}`, kind])) });
}

export function kindOf(component: { class: string; kind: string }, kinds = useKinds.getState()): Kind | undefined {
  return kinds.byName.get(`${component.class}/${component.kind}`);
}

/** One input as the drawing shows it: those of the kind, and those only the file knows. */
export interface InputPort {
  name: string;
  role: string;
  descriptor: PortDescriptor | undefined;
}

export function inputsOf(component: Component, kind: Kind | undefined): InputPort[] {
  const known = (kind?.ports ?? [])
    .filter((port) => port.direction === 'in')
    .map((descriptor) => ({ name: descriptor.name, role: descriptor.role, descriptor }));
  const extra = component.inputs
    .filter((input) => !known.some((port) => port.name === input.port))
    .map((input) => ({ name: input.port, role: 'feedback', descriptor: undefined }));
  return [...known, ...extra];
}

/** One thing a wire can start from. `text` is how a wire's text calls it; `handle` is "" for the component's command
 *  or its only value. */
export interface OutputPort {
  handle: string;
  label: string;
  role: string;
  text: string;
  unit: string;
  elements: string[];
  common: boolean;
}

function roleOf(component: Component, descriptor: PortDescriptor | undefined): string {
  if (component.class === 'goal') return 'request';
  if (descriptor?.role === 'appraisal') return 'appraisal';
  return component.class === 'sensation' || component.class === 'sensing' ? 'percept' : 'output';
}

function outputOf(component: Component, kind: Kind | undefined, output: Output, only: boolean): OutputPort {
  const descriptor = kind?.ports.find((port) => port.direction === 'out' && port.name === output.name);
  const plain = output.name === '' || only;
  return {
    handle: plain ? '' : output.name,
    label: output.name,
    role: roleOf(component, descriptor),
    text: plain ? component.id : `${component.id}.${output.name}`,
    unit: output.unit === '*' ? '' : output.unit,
    elements: output.elements,
    common: descriptor?.common ?? output.name === 'age_s',
  };
}

const outputsKnown = new WeakMap<Component, { kind: Kind | undefined; ports: OutputPort[] }>();

/** Made once of each component: a drawing asks for them at every wire. */
export function outputsOf(component: Component, kind: Kind | undefined): OutputPort[] {
  const known = outputsKnown.get(component);
  if (known && known.kind === kind) return known.ports;
  const ports = makeOutputs(component, kind);
  outputsKnown.set(component, { kind, ports });
  return ports;
}

function makeOutputs(component: Component, kind: Kind | undefined): OutputPort[] {
  const command = kind?.ports.find((port) => port.direction === 'out' && port.role === 'command');
  const values = component.outputs.filter((output) => output.name !== command?.name);
  const ports = values.map((output) =>
    outputOf(component, kind, output, values.length === 1 && !command && component.class !== 'goal'),
  );
  const whole = { handle: '', text: component.id, unit: '', elements: command?.elements ?? [], common: false };
  if (command) return [{ ...whole, label: command.name, role: 'command' }, ...ports];
  if (component.class === 'goal' && !ports.some((port) => port.handle === ''))
    return [{ ...whole, label: '', role: 'request' }, ...ports];
  return ports;
}

/** The handle a wire leaves from: its output, or the whole where the text names none or the only one. */
export function handleOf(ports: OutputPort[], output: string): string {
  if (ports.some((port) => port.handle === output)) return output;
  return ports.some((port) => port.handle === '' && port.label === output) ? '' : output;
}
