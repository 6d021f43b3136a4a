import { useEffect, useRef } from 'react';
import type { Exhibit, ShownBars, ShownCurve, ShownNetwork, Whose } from '../api/exhibits';
import type { Language } from '../api/types';
import { columnAt, isSeen } from '../state/frames';
import { player, usePlayer } from '../state/player';
import type { Timeline } from '../state/timeline';
import { onColours, useSettings } from '../theme/settings';
import { barsHeight, drawBars, drawCurve, kBarMargins, kCurveHeight, kCurveMargins } from './draw_curve';
import { drawNetwork, drawTable, kNetworkHeight, kNetworkMargins, kTableHeight, kTableMargins } from './draw_network';
import { sheetOn } from './sheet';
import { type WorldColours, worldColours } from './view';

const kForms = ['curve', 'bars', 'network'];

/** Things that are shown and lie nowhere in the world. */
function panelsOf(timeline: Timeline, robot: number): { of: Whose; title: Exhibit['title'] | undefined }[] {
  const exhibits = timeline.exhibits
    .filter(({ of }) => kForms.includes(of.form) && isSeen(of, robot))
    .map(({ of, track }) => ({ of, title: track.values.at(-1)?.title }));
  const tables = timeline.fields
    .filter(({ of, track }) => track.words?.frame === '' && isSeen(of, robot))
    .map(({ of, track }) => ({ of, title: track.words?.title }));
  return [...exhibits, ...tables];
}

const keyOf = (of: Whose) => `${of.robot} ${of.owner} ${of.form} ${of.name}`;

function drawExhibit(
  canvas: HTMLCanvasElement,
  timeline: Timeline,
  of: Whose,
  state: Exhibit,
  t: number,
  language: Language,
  colours: WorldColours,
): void {
  const on = (height: number, margins: typeof kCurveMargins) => sheetOn(canvas, height, margins, language, colours);
  if (of.form === 'curve') {
    const curve = state as ShownCurve;
    const sheet = on(kCurveHeight, kCurveMargins);
    const cursor = curve.cursor ? columnAt(timeline, of.robot, curve.cursor, t) : Number.NaN;
    if (sheet) drawCurve(sheet, curve, cursor);
  } else if (of.form === 'bars') {
    const bars = state as ShownBars;
    const sheet = on(barsHeight(bars.bars.length), kBarMargins);
    if (sheet) drawBars(sheet, bars);
  } else {
    const sheet = on(kNetworkHeight, kNetworkMargins);
    if (sheet) drawNetwork(sheet, state as ShownNetwork);
  }
}

function paintPanel(
  canvas: HTMLCanvasElement,
  timeline: Timeline,
  key: string,
  t: number,
  language: Language,
  colours: WorldColours,
): void {
  const table = timeline.fields.find(({ of }) => keyOf(of) === key);
  const field = table?.track.at(t);
  if (table) {
    const sheet = field && sheetOn(canvas, kTableHeight, kTableMargins, language, colours);
    if (sheet && field) drawTable(sheet, field);
    return;
  }
  const one = timeline.exhibits.find(({ of }) => keyOf(of) === key);
  const state = one?.track.at(t);
  if (one && state) drawExhibit(canvas, timeline, one.of, state, t, language, colours);
}

function Panel({ id, words, language }: { id: string; words: string; language: Language }) {
  const canvas = useRef<HTMLCanvasElement>(null);
  useEffect(() => {
    const element = canvas.current;
    if (!element) return;
    let colours = worldColours();
    const paint = player.addPainter((timeline, t) => paintPanel(element, timeline, id, t, language, colours));
    const coloured = onColours(() => {
      colours = worldColours();
      player.wake();
    });
    const sized = new ResizeObserver(() => player.wake());
    sized.observe(element);
    return () => {
      paint();
      coloured();
      sized.disconnect();
    };
  }, [id, language]);
  return (
    <figure>
      <figcaption>{words}</figcaption>
      <canvas ref={canvas} role="img" aria-label={words} />
    </figure>
  );
}

/** Curves, bars, networks and tables of the robot that is looked at. */
export function Panels({ timeline }: { timeline: Timeline }) {
  const robot = usePlayer((state) => state.robot);
  const language = useSettings((settings) => settings.language);
  const panels = panelsOf(timeline, robot);
  if (panels.length === 0) return null;
  return (
    <div className="panels">
      {panels.map(({ of, title }) => {
        const words = `${title?.[language] || of.name}${of.owner ? `: ${of.owner}` : ''}`;
        return <Panel key={keyOf(of)} id={keyOf(of)} words={words} language={language} />;
      })}
    </div>
  );
}
