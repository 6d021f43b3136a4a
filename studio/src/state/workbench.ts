import { create } from 'zustand';
import { ApiError } from '../api/client';
import { text } from '../text/text';

export type Centre = 'drawing' | 'table' | 'world';
export type Pane = 'files' | 'add' | 'history' | Centre | 'properties' | 'problems';

export type Dialog =
  | { kind: 'new' }
  | { kind: 'commands' }
  | { kind: 'keys' }
  | { kind: 'search' }
  | { kind: 'configure' }
  | { kind: 'set_goal' }
  | { kind: 'put_obstacle' }
  | { kind: 'rename'; id: string }
  | { kind: 'add'; from?: string; at?: [number, number] }
  | { kind: 'connect_to'; id: string; from?: string }
  | { kind: 'connect_from'; id: string; port: string };

export interface Toast {
  id: number;
  tone: 'note' | 'bad';
  title: string;
  lines: string[];
}

interface Workbench {
  centre: Centre;
  split: boolean;
  left: 'files' | 'add' | 'history';
  /** On narrow screens one pane is shown at a time. */
  pane: Pane;
  dialog: Dialog | null;
  toasts: Toast[];
  /** Said to screen readers. */
  said: string;
  minimap: boolean;
  expanded: ReadonlySet<string>;
  tour: number | null;
  problemsOpen: boolean;
}

export const useWorkbench = create<Workbench>(() => ({
  centre: 'drawing',
  split: false,
  left: 'files',
  pane: 'files',
  dialog: null,
  toasts: [],
  said: '',
  minimap: false,
  expanded: new Set(),
  tour: null,
  problemsOpen: false,
}));

const { setState: set } = useWorkbench;

export function show(pane: Pane): void {
  if (pane === 'drawing' || pane === 'table' || pane === 'world') set({ centre: pane, split: false, pane });
  else if (pane === 'files' || pane === 'add' || pane === 'history') set({ left: pane, pane });
  else if (pane === 'problems') set({ problemsOpen: true, pane });
  else set({ pane });
}

export function openDialog(dialog: Dialog): void {
  set({ dialog });
}

export function closeDialog(): void {
  set({ dialog: null });
}

export function say(said: string): void {
  set({ said });
}

let toasts = 0;
const kToast_ms = 7000;

export function toast(title: string, lines: string[] = [], tone: Toast['tone'] = 'note'): void {
  toasts += 1;
  const id = toasts;
  set((state) => ({
    toasts: [...state.toasts.slice(-2), { id, tone, title, lines }],
    said: [title, ...lines].join(' '),
  }));
  setTimeout(() => dismiss(id), kToast_ms);
}

export function dismiss(id: number): void {
  set((state) => ({ toasts: state.toasts.filter((one) => one.id !== id) }));
}

/** Says what went wrong: in the page's words for a code it knows, else in the server's. */
export function complain(error: unknown): void {
  const known = error instanceof ApiError ? text().errors[error.code] : undefined;
  const message = error instanceof Error ? error.message : String(error);
  toast(known ?? message, known && message && message !== known ? [message] : [], 'bad');
}

export function toggleExpanded(id: string): void {
  set((state) => {
    const expanded = new Set(state.expanded);
    if (!expanded.delete(id)) expanded.add(id);
    return { expanded };
  });
}
