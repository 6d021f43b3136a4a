import { create } from 'zustand';
import { api } from '../api/client';
import type { LinkTest, Recording, RunState } from '../api/types';
import { keep, kept } from '../theme/settings';
import { useDocument } from './document';
import type { Timeline } from './timeline';

export interface Configuration {
  experiment: string;
  world: string;
  robot: string;
  seed: number | null;
  duration_s: number | null;
  paused: boolean;
  record: boolean;
  application: Application;
  program: string;
  address: string;
  pace: number;
}

/** What the controller is run with. */
export type Application = 'experiment' | 'simulation' | 'address' | 'program';

interface Run {
  state: RunState | null;
  live: Timeline | null;
  recording: Recording | null;
  recorded: Timeline | null;
  /** Values are shown on the wires. */
  showing: boolean;
  configuration: Configuration;
  /** The last look at a robot. */
  linkTest: LinkTest | null;
  /** The text that runs, to tell whether it is the one that is drawn. */
  runText: string;
  /** Counts what goes on disk: lists of files are read again. */
  filesVersion: number;
}

export const useRun = create<Run>(() => ({
  state: null,
  live: null,
  recording: null,
  recorded: null,
  showing: false,
  configuration: {
    experiment: '',
    world: '',
    robot: '',
    seed: null,
    duration_s: null,
    paused: false,
    record: true,
    application: 'experiment',
    program: '',
    address: kept('address'),
    pace: 1,
  },
  linkTest: null,
  runText: '',
  filesVersion: 0,
}));

const { getState: get, setState: set } = useRun;

/** Something was written: lists of files are read again. */
export function filesChanged(): void {
  set((run) => ({ filesVersion: run.filesVersion + 1 }));
}

/** Whether the run's values belong to what is drawn. A run of the command line names no drawing of this folder. */
export function isOfDrawing({ state, recording }: Run, path: string): boolean {
  return recording !== null || !state?.controller || state.attached || state.controller === path;
}

export function configure(change: Partial<Configuration>): void {
  set((run) => ({ configuration: { ...run.configuration, ...change }, linkTest: null }));
  if (change.address !== undefined) keep('address', change.address);
  const { path } = useDocument.getState();
  if (change.experiment && path) keep(`experiment.${path}`, change.experiment);
}

/** Chooses the experiment that runs the drawn controller, where one does: the one chosen before, else the folder's
 *  experiment.toml, else the first. */
export async function chooseExperiment(): Promise<void> {
  const { experiments } = await api.files();
  const { path } = useDocument.getState();
  const folder = path.split('/').slice(0, -1).join('/');
  const before = kept(`experiment.${path}`);
  const main = (all: typeof experiments) => all.find((one) => /(^|\/)experiment\.toml$/.test(one.path)) ?? all[0];
  const known = experiments.some((one) => one.path === get().configuration.experiment);
  const own = main(experiments.filter((one) => one.controller === path));
  const near = main(experiments.filter((one) => one.path.startsWith(`${folder}/`)));
  const wanted = experiments.find((one) => one.path === before) ?? own ?? (known ? undefined : near);
  if (wanted && wanted.path !== get().configuration.experiment)
    configure({ experiment: wanted.path, world: '', robot: '', seed: null, duration_s: null });
}
