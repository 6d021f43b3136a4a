import { create } from 'zustand';
import { api } from '../api/client';
import { patiently } from '../api/presence';
import type { Model, Operation } from '../api/types';
import { share } from './share';

/** The drawing after one step: undo is an older one of these. */
export interface Step {
  text: string;
  model: Model;
  /** What was done: "opened", "reload" or the first operation's name. */
  step: string;
  about: string;
  merge: string;
  at_ms: number;
}

export interface Conflict {
  hash: string;
  text: string;
  gone: boolean;
}

interface DocumentState {
  path: string;
  /** Oldest first; never empty while a document is open. */
  steps: Step[];
  now: number;
  /** The text on the disk and its hash; "" = there is none yet. */
  savedText: string | null;
  hash: string;
  draft: { text: string; basedOn: string } | null;
  conflict: Conflict | null;
  selection: string[];
  busy: number;
}

const kMostSteps = 1000;
/** Two hundred can always be undone; more of them as long as their texts do not fill the memory. */
const kFewestSteps = 200;
const kMostCharacters = 64e6;
const kMergeWithin_ms = 1000;

const kClosed: DocumentState = {
  path: '',
  steps: [],
  now: -1,
  savedText: null,
  hash: '',
  draft: null,
  conflict: null,
  selection: [],
  busy: 0,
};

export const useDocument = create<DocumentState>(() => kClosed);

const { getState: get, setState: set } = useDocument;

/** The step that is shown; undefined where nothing is open. */
export function current(state: DocumentState = get()): Step | undefined {
  return state.steps[state.now];
}

export function useModel(): Model | undefined {
  return useDocument((state) => state.steps[state.now]?.model);
}

export function isDirty(state: DocumentState = get()): boolean {
  const step = current(state);
  return step !== undefined && step.text !== state.savedText;
}

export function place(): { path: string; text: string } {
  return { path: get().path, text: current()?.text ?? '' };
}

// Edits go one after the other: each starts from the text the one before came to.
let queue: Promise<unknown> = Promise.resolve();

export function inTurn<T>(work: () => Promise<T>): Promise<T> {
  const turn = queue.then(work);
  queue = turn.catch(() => undefined);
  return turn;
}

/** Resolves once every edit asked for so far is done. */
export function settled(): Promise<void> {
  return queue.then(() => undefined);
}

export function select(ids: string[]): void {
  const before = get().selection;
  if (before.length === ids.length && before.every((id, i) => id === ids[i])) return;
  set({ selection: ids });
}

/** The selection without what is gone; the same list where nothing is. */
function stillThere(selection: string[], model: Model): string[] {
  if (selection.length === 0) return selection;
  const alive = new Set(model.components.map((component) => component.id));
  return selection.every((id) => alive.has(id)) ? selection : selection.filter((id) => alive.has(id));
}

/** The newest of the steps, as many as are kept. */
export function kept(steps: Step[]): Step[] {
  let characters = 0;
  let first = steps.length;
  while (first > 0 && steps.length - first < kMostSteps) {
    characters += steps[first - 1].text.length;
    if (characters > kMostCharacters && steps.length - first >= kFewestSteps) break;
    first -= 1;
  }
  return first === 0 ? steps : steps.slice(first);
}

function push(step: Step): void {
  set((state) => {
    const before = state.steps[state.now];
    const joins =
      step.merge !== '' && before?.merge === step.merge && step.at_ms - before.at_ms < kMergeWithin_ms && state.now > 0;
    const past = state.steps.slice(0, joins ? state.now : state.now + 1);
    const steps = kept([...past, { ...step, model: share(before?.model, step.model) }]);
    return { steps, now: steps.length - 1, selection: stillThere(state.selection, step.model) };
  });
}

function aboutOf(operation: Operation): string {
  switch (operation.op) {
    case 'add':
      return operation.id ?? operation.kind;
    case 'remove':
      return operation.ids.join(', ');
    case 'rename':
      return `${operation.id} → ${operation.to}`;
    case 'set':
      return `${operation.id}.${operation.key}`.replace(/^\./, '');
    case 'unset':
      return `${operation.id}.${operation.key}`;
    case 'connect':
      return `${operation.from} → ${operation.id}.${operation.port}`;
    case 'disconnect':
    case 'reorder':
      return `${operation.id}.${operation.port}`;
    case 'move':
      return Object.keys(operation.positions).slice(0, 4).join(', ');
    case 'paste':
      return '';
  }
}

export interface EditOptions {
  /** Steps of the same mark that follow each other within a second become one. */
  merge?: string;
  /** Selects what was made. */
  selectMade?: boolean;
}

/** One gesture, one step. Resolves to the ids that were made; rejects with ApiError where the server refuses. While the
 *  server is away it waits: nothing that was done is lost. */
export function edit(operations: Operation[], options: EditOptions = {}): Promise<string[]> {
  if (operations.length === 0) return Promise.resolve([]);
  set((state) => ({ busy: state.busy + 1 }));
  return inTurn(async () => {
    try {
      const what = place();
      const answer = await patiently(() => api.edit(what, operations));
      if (get().path !== what.path) return [];
      const [first] = operations;
      push({
        text: answer.text,
        model: answer.model,
        step: first.op,
        about: aboutOf(first) || answer.ids.join(', '),
        merge: options.merge ?? '',
        at_ms: Date.now(),
      });
      if (options.selectMade) select(answer.ids);
      return answer.ids;
    } finally {
      set((state) => ({ busy: state.busy - 1 }));
    }
  });
}

/** Shows another step of the history; nothing is asked of the server. */
export function goTo(index: number): Promise<void> {
  return inTurn(async () => {
    const step = get().steps[index];
    if (!step) return;
    set((state) => ({ now: index, selection: stillThere(state.selection, step.model) }));
  });
}

/** The step that undo or redo would come to is known only in turn: edits may still be under way. */
export function undo(): Promise<void> {
  return settled().then(() => (get().now > 0 ? goTo(get().now - 1) : undefined));
}

export function redo(): Promise<void> {
  return settled().then(() => (get().now + 1 < get().steps.length ? goTo(get().now + 1) : undefined));
}

async function stepOf(path: string, text: string, step: string): Promise<Step> {
  const { model } = await api.open({ path, text });
  return { text, model, step, about: '', merge: '', at_ms: Date.now() };
}

/** Another document in this one's stead, whose history begins with what is on the disk. */
export async function begin(
  path: string,
  onDisk: Pick<DocumentState, 'hash' | 'draft'> & { savedText: string },
): Promise<void> {
  const first = await stepOf(path, onDisk.savedText, 'opened');
  set({ ...kClosed, path, steps: [first], now: 0, ...onDisk });
}

/** A whole other text as one more step, so that it can be undone. */
export function replaceText(text: string): Promise<void> {
  return inTurn(async () => push(await stepOf(get().path, text, 'reload')));
}

/** Asks for the drawing again in the language of now: messages come in it. */
export function reword(): Promise<void> {
  return inTurn(async () => {
    const step = current();
    if (!step) return;
    const { model } = await api.open(place());
    set((state) => ({
      steps: state.steps.map((one, i) => (i === state.now ? { ...one, model: share(one.model, model) } : one)),
    }));
  });
}
