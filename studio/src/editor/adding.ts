import { api } from '../api/client';
import type { Kind, Model, Operation, Value } from '../api/types';
import { current, edit, place, select } from '../state/document';
import { text } from '../text/text';
import type { Point } from './placing';

/** Something the palette offers. */
export interface Offered {
  class: string;
  kind: string;
  label: string;
  paper: string;
  help: string;
  set?: Record<string, Value>;
  id?: string;
}

const kClasses = ['goal', 'sensation', 'sensing', 'acting', 'coordinator'];

/** Everything that can be added: the kinds the server knows, and the channels the robot has. */
export function offered(kinds: Kind[], model: Model | undefined, language: 'en' | 'es'): Offered[] {
  const channels = (model?.robot.channels ?? []).map((channel) => ({
    class: 'sensation',
    kind: '',
    label: channel.name,
    paper: '',
    help: [text().types[channel.type] ?? channel.type, channel.unit && `[${channel.unit}]`, channel.elements.join(', ')]
      .filter(Boolean)
      .join(' '),
    set: { channel: channel.name },
    id: idFor(channel.name, model),
  }));
  const of = kinds
    .filter((kind) => kClasses.includes(kind.class))
    .map((kind) => ({
      class: kind.class,
      kind: kind.name,
      label: kind.name,
      paper: kind.paper_name,
      help: kind.summary[language],
    }));
  return [...channels, ...of].sort((a, b) => kClasses.indexOf(a.class) - kClasses.indexOf(b.class));
}

/** "sonar_left.range" -> "sonar_left", the first that is free; ids are made for kinds by the server. */
function idFor(channel: string, model: Model | undefined): string {
  const taken = new Set(model?.components.map((component) => component.id));
  const [device, value] = channel.split('.');
  for (const id of [value === 'range' ? device : (value ?? device), `${device}_${value}`])
    if (!taken.has(id)) return id;
  let n = 2;
  while (taken.has(`${device}_${value}_${n}`)) n += 1;
  return `${device}_${value}_${n}`;
}

export function addOperation(one: Offered, at: Point): Operation {
  return { op: 'add', class: one.class, kind: one.kind, id: one.id, set: one.set, position: at };
}

/** Adds it and, where a wire waits for it, connects that to the first input that takes it: one step to undo. */
export async function add(one: Offered, at: Point, from?: string, port?: string): Promise<void> {
  const before = new Set(current()?.model.components.map((component) => component.id));
  const operations: Operation[] = [addOperation({ ...one, id: one.id ?? freeId(one.kind, before) }, at)];
  const made = operations[0].op === 'add' ? operations[0].id : undefined;
  if (from && port && made) operations.push({ op: 'connect', from, id: made, port });
  const ids = await edit(operations);
  select(ids.filter((id) => !before.has(id)).slice(0, 1));
}

function freeId(kind: string, taken: ReadonlySet<string>): string {
  const plain = kind.replace(/(?<!^)([A-Z])/g, '_$1').toLowerCase();
  for (let n = 1; ; n += 1) {
    const id = n === 1 ? plain : `${plain}_${n}`;
    if (!taken.has(id)) return id;
  }
}

/** Of what is offered that which a wire fits, with the input it fits: tried by the server on a text that has one of
 *  each, which nobody sees. */
export async function fitting(all: Offered[], from: string): Promise<{ one: Offered; port: string }[]> {
  const kinds = all.filter((one) => one.kind !== '');
  const trial = await api.edit(
    place(),
    kinds.map((one, i) => ({ op: 'add', class: one.class, kind: one.kind, id: `trial_${i}_of_${kinds.length}` })),
  );
  const { targets } = await api.targets({ path: place().path, text: trial.text }, from);
  return kinds.flatMap((one, i) => {
    const fit = targets.find((target) => target.ok && target.id === `trial_${i}_of_${kinds.length}`);
    return fit ? [{ one, port: fit.port }] : [];
  });
}
