import { api } from '../api/client';
import { align, copy, cut, distribute, duplicate, paste, remove, tidy } from '../editor/actions';
import { fit } from '../editor/canvas_handle';
import { start } from '../run/start';
import { save } from '../state/disk';
import { current, redo, select, undo, useDocument } from '../state/document';
import { player, usePlayer } from '../state/player';
import { filesChanged, useRun } from '../state/run';
import { complain, openDialog, say, show, toast, useWorkbench } from '../state/workbench';
import type { Dictionary } from '../text/en';
import { text } from '../text/text';
import { isDark, useSettings } from '../theme/settings';
import { mayPutObstacle, maySetGoal } from '../world/reach';

export type CommandName = keyof Dictionary['commands'];

export interface Command {
  name: CommandName;
  menu: keyof Dictionary['menus'];
  /** As they are shown, and as key events are held against them: "Ctrl+Shift+Z". */
  keys?: string[];
  run(): unknown;
  enabled?(): boolean;
}

const isOpen = () => current() !== undefined;
const chosen = () => useDocument.getState().selection.length > 0;
const one = () => useDocument.getState().selection.length === 1;
const runState = () => useRun.getState().state?.state ?? 'idle';
const steers = () => !useRun.getState().state?.attached;
const isRunning = () => ['preparing', 'armed', 'running', 'paused'].includes(runState()) && steers();
const isShown = () => usePlayer.getState().timeline !== null;
const first = () => useDocument.getState().selection[0];

async function saveAndSay(): Promise<void> {
  if (await save()) {
    toast(text().save.saved);
    filesChanged();
  }
}

/** Run what is drawn; with problems, or without an experiment, shows what is in the way. */
async function runOrExplain(): Promise<void> {
  const model = current()?.model;
  if (model && model.problems.length > 0) {
    show('problems');
    toast(text().run.blocked(model.problems.length), [], 'bad');
    return;
  }
  if (!useRun.getState().configuration.experiment) return openDialog({ kind: 'configure' });
  await start();
  if (useWorkbench.getState().centre !== 'world') {
    if (innerWidth >= 1200) useWorkbench.setState({ split: true, centre: 'drawing' });
    else show('world');
  }
}

function pauseOrGoOn(): unknown {
  if (!useRun.getState().recording && isRunning()) return runState() === 'running' ? api.pause() : api.resume();
  return player.play(!usePlayer.getState().playing);
}

function stepOn(): unknown {
  if (!useRun.getState().recording && isRunning() && usePlayer.getState().following) return api.step(1);
  return player.step(1);
}

/** Every command there is: menu, palette, keys and help are made of this table. */
export const kCommands: Command[] = [
  { name: 'new', menu: 'file', run: () => openDialog({ kind: 'new' }) },
  { name: 'save', menu: 'file', keys: ['Ctrl+S'], run: saveAndSay, enabled: isOpen },
  {
    name: 'undo',
    menu: 'edit',
    keys: ['Ctrl+Z'],
    run: () => undo().then(() => say(text().shell.undone)),
    enabled: () => useDocument.getState().now > 0,
  },
  {
    name: 'redo',
    menu: 'edit',
    keys: ['Ctrl+Shift+Z', 'Ctrl+Y'],
    run: () => redo().then(() => say(text().shell.redone)),
    enabled: () => useDocument.getState().now + 1 < useDocument.getState().steps.length,
  },
  { name: 'cut', menu: 'edit', keys: ['Ctrl+X'], run: cut, enabled: chosen },
  { name: 'copy', menu: 'edit', keys: ['Ctrl+C'], run: copy, enabled: chosen },
  { name: 'paste', menu: 'edit', keys: ['Ctrl+V'], run: paste, enabled: isOpen },
  { name: 'duplicate', menu: 'edit', keys: ['Ctrl+D'], run: duplicate, enabled: chosen },
  { name: 'delete', menu: 'edit', keys: ['Delete', 'Backspace'], run: remove, enabled: isOpen },
  {
    name: 'select_all',
    menu: 'edit',
    keys: ['Ctrl+A'],
    run: () => select(current()?.model.components.map((component) => component.id) ?? []),
    enabled: isOpen,
  },
  { name: 'rename', menu: 'edit', keys: ['F2'], run: () => openDialog({ kind: 'rename', id: first() }), enabled: one },
  { name: 'add', menu: 'edit', keys: ['A'], run: () => openDialog({ kind: 'add' }), enabled: isOpen },
  {
    name: 'connect',
    menu: 'edit',
    keys: ['C'],
    run: () => openDialog({ kind: 'connect_to', id: first() }),
    enabled: one,
  },
  { name: 'align_left', menu: 'edit', run: () => align('left'), enabled: chosen },
  { name: 'align_top', menu: 'edit', run: () => align('top'), enabled: chosen },
  { name: 'distribute', menu: 'edit', run: distribute, enabled: chosen },
  { name: 'tidy', menu: 'edit', run: tidy, enabled: isOpen },
  { name: 'search', menu: 'view', keys: ['Ctrl+F'], run: () => openDialog({ kind: 'search' }), enabled: isOpen },
  { name: 'fit', menu: 'view', keys: ['F', '1'], run: fit, enabled: isOpen },
  {
    name: 'minimap',
    menu: 'view',
    keys: ['M'],
    run: () => useWorkbench.setState((state) => ({ minimap: !state.minimap })),
    enabled: isOpen,
  },
  { name: 'show_drawing', menu: 'view', keys: ['Alt+1'], run: () => show('drawing') },
  { name: 'show_table', menu: 'view', keys: ['Alt+2'], run: () => show('table') },
  { name: 'show_world', menu: 'view', keys: ['Alt+3'], run: () => show('world') },
  {
    name: 'side_by_side',
    menu: 'view',
    run: () => useWorkbench.setState((state) => ({ split: !state.split, centre: 'drawing', pane: 'drawing' })),
  },
  {
    name: 'theme',
    menu: 'view',
    run: () => useSettings.getState().setTheme(isDark() ? 'light' : 'dark'),
  },
  {
    name: 'language',
    menu: 'view',
    run: () => useSettings.getState().setLanguage(useSettings.getState().language === 'en' ? 'es' : 'en'),
  },
  { name: 'configure', menu: 'run', run: () => openDialog({ kind: 'configure' }) },
  { name: 'run', menu: 'run', keys: ['F5'], run: runOrExplain, enabled: () => !isRunning() && steers() },
  { name: 'pause', menu: 'run', keys: ['Space'], run: pauseOrGoOn, enabled: () => isRunning() || isShown() },
  { name: 'step', menu: 'run', keys: ['.'], run: stepOn, enabled: () => isRunning() || isShown() },
  { name: 'back', menu: 'run', keys: [','], run: () => player.step(-1), enabled: isShown },
  { name: 'stop', menu: 'run', keys: ['Shift+F5'], run: () => api.stop(), enabled: isRunning },
  {
    name: 'reset',
    menu: 'run',
    run: () => api.reset(),
    enabled: () => ['running', 'paused', 'done', 'armed'].includes(runState()) && steers(),
  },
  {
    name: 'hold_view',
    menu: 'run',
    keys: ['H'],
    run: () => player.follow(!usePlayer.getState().following),
    enabled: () => usePlayer.getState().growing,
  },
  { name: 'set_goal', menu: 'run', keys: ['G'], run: () => openDialog({ kind: 'set_goal' }), enabled: maySetGoal },
  { name: 'put_obstacle', menu: 'run', run: () => openDialog({ kind: 'put_obstacle' }), enabled: mayPutObstacle },
  { name: 'palette', menu: 'help', keys: ['Ctrl+K'], run: () => openDialog({ kind: 'commands' }) },
  { name: 'keys', menu: 'help', keys: ['?'], run: () => openDialog({ kind: 'keys' }) },
  { name: 'tour', menu: 'help', run: () => useWorkbench.setState({ tour: 0 }) },
];

export function commandOf(name: CommandName): Command {
  return kCommands.find((command) => command.name === name) as Command;
}

/** Carries a command out, if it can be now; what fails is said. */
export async function carryOut(command: Command): Promise<void> {
  if (command.enabled && !command.enabled()) return;
  try {
    await command.run();
  } catch (error) {
    complain(error);
  }
}
