import { readdirSync, readFileSync } from 'node:fs';
import { setPriority } from 'node:os';

/** Memory that a process has in use [MiB]. */
export function resident_MiB(pid: number): number {
  const found = readFileSync(`/proc/${pid}/status`, 'utf8').match(/VmRSS:\s+(\d+) kB/);
  return Number(found?.[1] ?? 0) / 1024;
}

const kTicksPerSecond = 100;

/** What a process has computed so far [s]. */
export function cpu_s(pid: number): number {
  const words = readFileSync(`/proc/${pid}/stat`, 'utf8').split(') ')[1].split(' ');
  return (Number(words[11]) + Number(words[12])) / kTicksPerSecond;
}

/** Rise of the straight line that fits best, and how far its two ends lie apart. */
export function trend(times: readonly number[], values: readonly number[]): { rise: number; change: number } {
  const mean = (list: readonly number[]) => list.reduce((sum, one) => sum + one, 0) / list.length;
  const [t, v] = [mean(times), mean(values)];
  const square = times.reduce((sum, one) => sum + (one - t) ** 2, 0);
  const rise = times.reduce((sum, one, i) => sum + (one - t) * (values[i] - v), 0) / square;
  return { rise, change: rise * (times[times.length - 1] - times[0]) };
}

const kFavoured = -18;

/** Puts processes before those of others on a busy machine, where we may: Chromium gives its threads a niceness of its
 *  own, so that `nice` before the command does not reach them. */
export function favour(pids: readonly number[]): void {
  for (const pid of pids) {
    try {
      for (const thread of readdirSync(`/proc/${pid}/task`)) setPriority(Number(thread), kFavoured);
    } catch {
      return; // not root, or ended: measured as it comes
    }
  }
}
