import { create } from 'zustand';
import { api, type StartRun } from '../api/client';
import { decodeSamples, type Sample } from '../api/samples';
import { Connection } from '../api/socket';
import { absent, present } from '../api/presence';
import type { Hello, LinkTest, Outcome, Recording, RunState, StudioEvent } from '../api/types';
import { current, fileChanged, useDocument } from '../state/document';
import { text } from '../text/text';
import { keep, kept, useSettings } from '../theme/settings';
import { complain, say, toast } from '../state/workbench';
import { player } from '../state/player';
import { Timeline } from '../state/timeline';

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
const kMostToComplete = 32 << 20; // bytes of rows

function showLive(timeline: Timeline): void {
  set({ live: timeline, recording: null, recorded: null, showing: true });
  player.show(timeline, true);
}

/** A server that was started anew watches no file yet; opening it again says whether it changed meanwhile. */
async function lookAtFile(): Promise<void> {
  const { path, hash } = useDocument.getState();
  if (!path || !hash) return;
  const file = await api.openFile(path);
  await fileChanged(path, file.hash);
}

function welcome(hello: Hello): void {
  set({ state: hello.state });
  lookAtFile().catch(complain);
  if (hello.streams.length > 0 && !get().recording) showLive(new Timeline(hello.streams, hello.scene, hello.info));
}

/** Why a run ended, in the language of now. */
/** Whether the run's values belong to what is drawn. A run of the command line names no drawing of this folder. */
export function isOfDrawing({ state, recording }: Run, path: string): boolean {
  return recording !== null || !state?.controller || state.attached || state.controller === path;
}

/** Its task, or that somebody ended it before there could be a verdict. */
export function verdict(outcome: Outcome): { words: string; tone: 'good' | 'bad' | '' } {
  const words = text().run;
  if (outcome.success) return { words: words.success, tone: 'good' };
  if (outcome.reason.startsWith('interrupted')) return { words: words.interrupted, tone: '' };
  return { words: words.failure, tone: 'bad' };
}

export function outcomeWords(outcome: Outcome): string {
  const spanish = useSettings.getState().language === 'es';
  return spanish
    ? outcome.error_es || outcome.error || outcome.reason_es || outcome.reason
    : outcome.error || outcome.reason;
}

function sayOutcome(before: RunState | null, state: RunState): void {
  if (state.state !== 'done' || before?.state === 'done' || !state.outcome) return;
  const { outcome } = state;
  toast(
    verdict(outcome).words,
    [outcomeWords(outcome)].filter(Boolean),
    outcome.error ? 'bad' : 'note',
  );
}

function takeState(state: RunState): void {
  sayOutcome(get().state, state);
  const ended = state.state === 'done' && get().state?.state !== 'done';
  set((run) => ({ state, filesVersion: run.filesVersion + (ended ? 1 : 0) }));
  if (ended && state.outcome?.file) completeFrom(state.outcome.file, state.time_s).catch(complain);
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
    case 'link':
      set({ linkTest: event });
      break;
    case 'file':
      set((run) => ({ filesVersion: run.filesVersion + 1 }));
      fileChanged(event.path, event.hash).then((what) => what === 'reloaded' && toast(text().save.reloaded), complain);
  }
}

function takeSample(sample: Sample): void {
  const { live } = get();
  if (!live?.complete) live?.add(sample);
  player.wake();
}

export function connect(): Connection {
  const scheme = location.protocol === 'https:' ? 'wss' : 'ws';
  return new Connection(`${scheme}://${location.host}/ws`, {
    hello: welcome,
    event: takeEvent,
    sample: takeSample,
    connected: (connected) => (connected ? present() : absent()),
  });
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

/** What is drawn, saved or not, as it is configured. */
function wantedRun(): StartRun {
  const { configuration } = get();
  const step = current();
  return {
    experiment: configuration.experiment,
    pace: configuration.pace,
    record: configuration.record,
    paused: configuration.paused,
    ...(step ? { controller: { path: useDocument.getState().path, text: step.text } } : {}),
    ...(configuration.world ? { world: configuration.world } : {}),
    ...(configuration.robot ? { robot: configuration.robot } : {}),
    ...(configuration.seed !== null ? { seed: configuration.seed } : {}),
    ...(configuration.duration_s !== null ? { duration_s: configuration.duration_s } : {}),
    ...(configuration.application === 'simulation' ? { address: '' } : {}),
    ...(configuration.application === 'address' ? { address: configuration.address.trim() } : {}),
    ...(configuration.application === 'program' ? { program: configuration.program } : {}),
  };
}

export async function start(): Promise<void> {
  set({ runText: current()?.text ?? '' });
  await api.start(wantedRun());
}

/** Has the server look at the robot; what it finds comes as events. */
export async function testLink(): Promise<void> {
  set({ linkTest: null });
  const { test } = await api.testLink(wantedRun());
  set((run) => (run.linkTest?.test === test.test ? {} : { linkTest: test }));
}

async function load(path: string): Promise<{ recording: Recording; timeline: Timeline }> {
  const [recording, bytes] = await Promise.all([api.recording(path), api.samples(path)]);
  const timeline = new Timeline(recording.streams, recording.scene, recording.info);
  for (const sample of decodeSamples(bytes)) timeline.add(sample);
  for (const event of recording.events) timeline.addEvent(event);
  timeline.end = Math.max(timeline.end, recording.duration_s);
  return { recording, timeline };
}

/** Of a run that was faster than it could be watched not every tick was sent: its trail would lead straight through
 *  walls. Its file has them all. */
async function completeFrom(path: string, time_s: number): Promise<void> {
  const { live } = get();
  if (!live || live.isWhole(time_s) || live.bytesOf(time_s) > kMostToComplete) return;
  const { timeline } = await load(path);
  timeline.complete = true;
  if (get().live !== live) return; // the next run has begun
  set({ live: timeline });
  if (!get().recording) player.replace(timeline);
}

export async function openRecording(path: string): Promise<void> {
  const { recording, timeline } = await load(path);
  set({ recording, recorded: timeline, showing: true });
  player.show(timeline, false);
}

export function closeRecording(): void {
  const { live } = get();
  set({ recording: null, recorded: null, showing: live !== null });
  if (live) player.show(live, true);
}
