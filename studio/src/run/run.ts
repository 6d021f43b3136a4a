import { create } from 'zustand';
import { api, type StartRun } from '../api/client';
import { decodeSamples, type Sample } from '../api/samples';
import { Connection } from '../api/socket';
import type { Hello, Recording, RunState, StudioEvent } from '../api/types';
import { current, fileChanged, useDocument } from '../document/document';
import { text } from '../text/text';
import { complain, say, toast, useWorkbench } from '../ui/workbench';
import { player } from '../world/player';
import { Timeline } from '../world/timeline';

export interface Configuration {
  experiment: string;
  world: string;
  robot: string;
  seed: number | null;
  duration_s: number | null;
  paused: boolean;
  record: boolean;
  program: string;
  pace: number;
}

interface Run {
  state: RunState | null;
  live: Timeline | null;
  recording: Recording | null;
  recorded: Timeline | null;
  /** Values are shown on the wires. */
  showing: boolean;
  configuration: Configuration;
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
    program: '',
    pace: 1,
  },
  runText: '',
  filesVersion: 0,
}));

const { getState: get, setState: set } = useRun;

function showLive(timeline: Timeline): void {
  set({ live: timeline, recording: null, recorded: null, showing: true });
  player.show(timeline, true);
}

function welcome(hello: Hello): void {
  set({ state: hello.state });
  if (hello.streams.length > 0 && !get().recording) showLive(new Timeline(hello.streams, hello.scene, hello.info));
}

function sayOutcome(before: RunState | null, state: RunState): void {
  if (state.state !== 'done' || before?.state === 'done' || !state.outcome) return;
  const { outcome } = state;
  const words = text().run;
  toast(
    outcome.success ? words.success : words.failure,
    [outcome.error || outcome.reason].filter(Boolean),
    outcome.error ? 'bad' : 'note',
  );
}

function takeState(state: RunState): void {
  sayOutcome(get().state, state);
  const ended = state.state === 'done' && get().state?.state !== 'done';
  set((run) => ({ state, filesVersion: run.filesVersion + (ended ? 1 : 0) }));
}

function takeEvent(event: StudioEvent): void {
  switch (event.event) {
    case 'run':
      takeState(event.state);
      break;
    case 'streams':
      if (event.more) get().live?.addStreams(event.streams);
      else showLive(new Timeline(event.streams, event.scene, event.info));
      break;
    case 'goal':
      if (event.state === 'reached') say(text().run.goal_reached);
      get().live?.addEvent(event);
      player.tellEvent();
      break;
    case 'intervention':
      get().live?.addEvent(event);
      player.tellEvent();
      break;
    case 'log':
      get().live?.addEvent(event);
      break;
    case 'file':
      set((run) => ({ filesVersion: run.filesVersion + 1 }));
      fileChanged(event.path, event.hash).then((what) => what === 'reloaded' && toast(text().save.reloaded), complain);
  }
}

function takeSample(sample: Sample): void {
  get().live?.add(sample);
  player.wake();
}

export function connect(): Connection {
  const scheme = location.protocol === 'https:' ? 'wss' : 'ws';
  return new Connection(`${scheme}://${location.host}/ws`, {
    hello: welcome,
    event: takeEvent,
    sample: takeSample,
    connected: (connected) => useWorkbench.setState({ connected }),
  });
}

export function configure(change: Partial<Configuration>): void {
  set((run) => ({ configuration: { ...run.configuration, ...change } }));
}

/** Chooses the experiment that runs the drawn controller, where one does. */
export async function chooseExperiment(): Promise<void> {
  const { experiments } = await api.files();
  const { path } = useDocument.getState();
  const folder = path.split('/').slice(0, -1).join('/');
  const known = experiments.some((one) => one.path === get().configuration.experiment);
  const own = experiments.find((one) => one.controller === path);
  const near = experiments.find((one) => one.path.startsWith(`${folder}/`));
  const wanted = own ?? (known ? undefined : near);
  if (wanted) configure({ experiment: wanted.path, world: '', robot: '', seed: null, duration_s: null });
}

/** Starts what is drawn, saved or not. */
export async function start(): Promise<void> {
  const { configuration } = get();
  const step = current();
  const wanted: StartRun = {
    experiment: configuration.experiment,
    pace: configuration.pace,
    record: configuration.record,
    paused: configuration.paused,
    ...(step ? { controller: { path: useDocument.getState().path, text: step.text } } : {}),
    ...(configuration.world ? { world: configuration.world } : {}),
    ...(configuration.robot ? { robot: configuration.robot } : {}),
    ...(configuration.seed !== null ? { seed: configuration.seed } : {}),
    ...(configuration.duration_s !== null ? { duration_s: configuration.duration_s } : {}),
    ...(configuration.program ? { program: configuration.program } : {}),
  };
  set({ runText: step?.text ?? '' });
  await api.start(wanted);
}

export async function openRecording(path: string): Promise<void> {
  const [recording, bytes] = await Promise.all([api.recording(path), api.samples(path)]);
  const timeline = new Timeline(recording.streams, recording.scene, recording.info);
  for (const sample of decodeSamples(bytes)) timeline.add(sample);
  for (const event of recording.events) timeline.addEvent(event);
  timeline.end = Math.max(timeline.end, recording.duration_s);
  set({ recording, recorded: timeline, showing: true });
  player.show(timeline, false);
}

export function closeRecording(): void {
  const { live } = get();
  set({ recording: null, recorded: null, showing: live !== null });
  if (live) player.show(live, true);
}
