import { api } from '../api/client';
import { decodeSamples } from '../api/samples';
import type { Recording } from '../api/types';
import { player } from './player';
import { useRun } from './run';
import { Timeline } from './timeline';

/** All that a run file has, read at once. */
export async function loadRecording(path: string): Promise<{ recording: Recording; timeline: Timeline }> {
  const [recording, bytes] = await Promise.all([api.recording(path), api.samples(path)]);
  const timeline = new Timeline(recording.streams, recording.scene, recording.info);
  for (const sample of decodeSamples(bytes)) timeline.add(sample);
  for (const event of recording.events) timeline.addEvent(event);
  timeline.end = Math.max(timeline.end, recording.duration_s);
  return { recording, timeline };
}

export async function openRecording(path: string): Promise<void> {
  const { recording, timeline } = await loadRecording(path);
  useRun.setState({ recording, recorded: timeline, showing: true });
  player.show(timeline, false);
}

export function closeRecording(): void {
  const { live } = useRun.getState();
  useRun.setState({ recording: null, recorded: null, showing: live !== null });
  if (live) player.show(live, true);
}
