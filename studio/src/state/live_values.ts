import { text } from '../text/text';
import type { RowTrack } from './rows';
import type { Timeline } from './timeline';

/** Where a wire's value is found: the first of `signals` that is a column, or whose elements are. */
export interface ValueSource {
  signals: string[];
  elements: string[];
  unit: string;
}

const kHistory = 120;
const kOldest_s = 0.25;

interface Watch {
  source: ValueSource;
  robot: RowTrack | null;
  columns: number[];
  age: number;
  shown: string;
}

const watches = new Map<HTMLElement, Watch>();
let now: { timeline: Timeline; row: number; robot: number } | null = null;

function columnsFor(robot: RowTrack, source: ValueSource): number[] {
  for (const signal of source.signals) {
    const parts = source.elements.map((element) => robot.columns.get(`${signal}.${element}`));
    if (parts.length > 0 && parts.every((part) => part !== undefined)) return parts as number[];
    const whole = robot.columns.get(signal);
    if (whole !== undefined) return [whole];
  }
  return [];
}

/** Has an element show a value from now on; the answer ends that. */
export function watchValue(element: HTMLElement, source: ValueSource): () => void {
  watches.set(element, { source, robot: null, columns: [], age: -1, shown: '\0' });
  if (now) writeOne(element, watches.get(element) as Watch);
  return () => watches.delete(element);
}

export function wordsOf(value: number): string {
  const { values } = text();
  if (Number.isNaN(value)) return values.none;
  if (value === Number.POSITIVE_INFINITY) return values.far;
  if (value === Number.NEGATIVE_INFINITY) return values.near;
  if (Number.isInteger(value)) return `${value}`;
  return Math.abs(value) >= 100 ? value.toFixed(1) : value.toFixed(Math.abs(value) >= 10 ? 2 : 3);
}

function writeOne(element: HTMLElement, watch: Watch): void {
  if (!now) return;
  const robot = now.timeline.robots[now.robot];
  if (!robot) return;
  if (watch.robot !== robot) {
    watch.robot = robot;
    watch.columns = columnsFor(robot, watch.source);
    watch.age = robot.columns.get(`${watch.source.signals[0].split('.')[0]}.age_s`) ?? -1;
    element.hidden = watch.columns.length === 0;
  }
  if (now.row < 0 || watch.columns.length === 0) return;
  const { row } = now;
  const age = watch.age < 0 ? 0 : robot.value(row, watch.age);
  const stale = age > kOldest_s;
  const unit = watch.source.unit ? ` ${watch.source.unit}` : '';
  const words = `${watch.columns.map((column) => wordsOf(robot.value(row, column))).join(', ')}${unit}`;
  const shown = stale ? `${words} (${text().values.stale} ${age.toFixed(1)} s)` : words;
  if (shown === watch.shown) return;
  watch.shown = shown;
  element.textContent = shown;
  element.classList.toggle('stale', stale);
}

/** Writes every value as it was at t, past React: hundreds of them keep up with the screen so. */
export function writeValues(timeline: Timeline, t: number, robot: number): void {
  now = { timeline, row: timeline.robots[robot]?.at(t) ?? -1, robot };
  for (const [element, watch] of watches) writeOne(element, watch);
}

/** The last values of a wire up to what is shown, the oldest first. */
export function history(source: ValueSource): number[] {
  const robot = now?.timeline.robots[now.robot];
  if (!robot || !now) return [];
  const [column] = columnsFor(robot, source);
  if (column === undefined) return [];
  const values: number[] = [];
  for (let row = Math.max(0, now.row + 1 - kHistory); row <= now.row; row += 1) values.push(robot.value(row, column));
  return values;
}
