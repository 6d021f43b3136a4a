import { api } from '../api/client';
import { absent, present } from '../api/presence';
import type { Sample } from '../api/samples';
import { Connection } from '../api/socket';
import type { Hello, RunState, StudioEvent } from '../api/types';
import { fileChanged } from '../state/disk';
import { useDocument } from '../state/document';
import { player } from '../state/player';
import { loadRecording } from '../state/recordings';
import { filesChanged, useRun } from '../state/run';
import { Timeline } from '../state/timeline';
import { complain, say, toast } from '../state/workbench';
import { isNote, logWords } from '../text/log';
import { text } from '../text/text';
import { useSettings } from '../theme/settings';
import { outcomeWords, verdict } from './verdict';

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

function sayOutcome(before: RunState | null, state: RunState): void {
  if (state.state !== 'done' || before?.state === 'done' || !state.outcome) return;
  const { outcome } = state;
  toast(verdict(outcome).words, [outcomeWords(outcome)].filter(Boolean), outcome.error ? 'bad' : 'note');
}

function takeState(state: RunState): void {
  sayOutcome(get().state, state);
  const ended = state.state === 'done' && get().state?.state !== 'done';
  set({ state });
  if (ended) filesChanged();
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
    case 'intervention':
      get().live?.addEvent(event);
      player.tellEvent();
      break;
    case 'log':
      if (isNote(event)) say(logWords(event, useSettings.getState().language));
      get().live?.addEvent(event);
      player.tellEvent();
      break;
    case 'link':
      set({ linkTest: event });
      break;
    case 'file':
      filesChanged();
      fileChanged(event.path, event.hash).then((what) => what === 'reloaded' && toast(text().save.reloaded), complain);
  }
}

function takeSample(sample: Sample): void {
  const { live } = get();
  if (!live?.complete) live?.add(sample);
  player.wake();
}

/** What the server tells goes into the state from now on. */
export function connect(): Connection {
  const scheme = location.protocol === 'https:' ? 'wss' : 'ws';
  return new Connection(`${scheme}://${location.host}/ws`, {
    hello: welcome,
    event: takeEvent,
    sample: takeSample,
    connected: (connected) => (connected ? present() : absent()),
  });
}

/** Of a run that was faster than it could be watched not every tick was sent: its trail would lead straight through
 *  walls. Its file has them all. */
async function completeFrom(path: string, time_s: number): Promise<void> {
  const { live } = get();
  if (!live || live.isWhole(time_s) || live.bytesOf(time_s) > kMostToComplete) return;
  const { timeline } = await loadRecording(path);
  timeline.complete = true;
  if (get().live !== live) return; // the next run has begun
  set({ live: timeline });
  if (!get().recording) player.replace(timeline);
}
