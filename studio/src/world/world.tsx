import { useEffect, useRef, useState } from 'react';
import type { Language } from '../api/types';
import { isSeen } from '../state/frames';
import { player, usePlayer } from '../state/player';
import { closeRecording } from '../state/recordings';
import { useRun } from '../state/run';
import type { Timeline } from '../state/timeline';
import { useText } from '../text/text';
import { onColours, useSettings } from '../theme/settings';
import { Icon } from '../ui/icons';
import { FieldPainter } from './draw_field';
import { drawIntent } from './draw_intent';
import { poseAt } from './draw_robot';
import { Drives } from './drives';
import { Events } from './events';
import { useHand } from './hand';
import { Legend } from './legend';
import { type ChosenLayer, paintWorld } from './paint';
import { Panels } from './panels';
import { type Intent, mayPutObstacle, maySetGoal } from './reach';
import { TimeBar } from './time_bar';
import { View, worldColours } from './view';

const kZoomStep = 1.3;
const kNothingChosen: ChosenLayer = { field: '', layer: '' };

function useWorldCanvas({ field, layer }: ChosenLayer) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const view = useRef<View | null>(null);
  const intent = useRef<Intent>({ cell: null, ghost: null });
  useEffect(() => {
    const element = canvas.current;
    if (!element) return;
    view.current = view.current ?? new View(element);
    const seen = view.current;
    const painter = new FieldPainter();
    let colours = worldColours();
    const paint = player.addPainter((timeline, t, robot) => {
      paintWorld(seen, painter, timeline, t, robot, { field, layer }, colours);
      drawIntent(seen, timeline, intent.current, colours);
    });
    const coloured = onColours(() => {
      colours = worldColours();
      player.wake();
    });
    const sized = new ResizeObserver(() => player.wake());
    sized.observe(element);
    const wheel = (event: WheelEvent) => {
      event.preventDefault();
      const box = element.getBoundingClientRect();
      seen.zoomBy(event.deltaY < 0 ? kZoomStep : 1 / kZoomStep, event.clientX - box.left, event.clientY - box.top);
      player.wake();
    };
    element.addEventListener('wheel', wheel, { passive: false });
    return () => {
      paint();
      coloured();
      sized.disconnect();
      element.removeEventListener('wheel', wheel);
    };
  }, [field, layer]);
  return { canvas, view, intent };
}

/** Every layer of every field that lies in a frame; those of a name count as one, whoever shows them. */
function choices(timeline: Timeline | null, robot: number, language: Language) {
  const found = new Map<string, { chosen: ChosenLayer; words: string; scale: boolean }>();
  for (const { of, track } of timeline?.fields ?? []) {
    if (!track.words || track.words.frame === '' || !isSeen(of, robot)) continue;
    for (const one of track.words.layers) {
      const words = `${track.words.title[language]}: ${one.title[language]}`;
      const scale = one.classes.length === 0;
      found.set(`${of.name}\n${one.name}`, { chosen: { field: of.name, layer: one.name }, words, scale });
    }
  }
  return [...found.entries()].map(([key, one]) => ({ key, ...one }));
}

type Choice = ReturnType<typeof choices>[number];

function Tools({
  view,
  chosen,
  layers,
  choose,
}: {
  view: { current: View | null };
  chosen: string;
  layers: Choice[];
  choose(key: string): void;
}) {
  const text = useText();
  const act = (work: (view: View) => void) => () => {
    if (view.current) work(view.current);
    player.wake();
  };
  return (
    <div className="world-tools">
      {layers.length > 0 && (
        <label>
          {text.world.field}{' '}
          <select value={chosen} onChange={(event) => choose(event.target.value)}>
            <option value="">{text.world.no_field}</option>
            {layers.map(({ key, words }) => (
              <option key={key} value={key}>
                {words}
              </option>
            ))}
          </select>
        </label>
      )}
      <button type="button" aria-label={text.world.zoom_in} onClick={act((seen) => seen.zoomBy(kZoomStep))}>
        <Icon name="plus" />
      </button>
      <button type="button" aria-label={text.world.zoom_out} onClick={act((seen) => seen.zoomBy(1 / kZoomStep))}>
        <Icon name="minus" />
      </button>
      <button type="button" aria-label={text.world.zoom_all} onClick={act((seen) => seen.whole())}>
        <Icon name="fit" />
      </button>
    </div>
  );
}

/** What the canvas shows, in words, for those who do not see it. */
function Spoken() {
  const text = useText();
  const { timeline, t, robot } = usePlayer();
  const pose = timeline && poseAt(timeline, robot, t);
  if (!pose) return null;
  const degrees = ((pose.yaw * 180) / Math.PI).toFixed(0);
  return <p className="world-words">{text.world.describe(pose.x.toFixed(2), pose.y.toFixed(2), degrees)}</p>;
}

function RecordingBar() {
  const text = useText();
  const recording = useRun((state) => state.recording);
  if (!recording) return null;
  return (
    <div className="recording-bar">
      <b>{text.world.recording(recording.run.name || recording.run.path)}</b>
      <small>{text.files.seed(recording.run.seed)}</small>
      <button type="button" onClick={closeRecording}>
        {text.world.close}
      </button>
    </div>
  );
}

/** What a pointer can do to the world, while it can. */
function Hint() {
  const text = useText();
  usePlayer((state) => state.following && state.timeline);
  useRun((run) => run.state?.state);
  useRun((run) => run.recording);
  const words = [maySetGoal() && text.reach.hint_goal, mayPutObstacle() && text.reach.hint_obstacle].filter(Boolean);
  return words.length > 0 ? <p className="world-hint">{words.join(' ')}</p> : null;
}

/** The world of the run that is looked at, live or recorded, with its time. */
export function World() {
  const text = useText();
  const timeline = usePlayer((state) => state.timeline);
  // What is shown comes to a run that goes on: the timeline stays the same object.
  usePlayer(
    ({ timeline: one }) => one && `${one.fields.filter(({ track }) => track.words).length} ${one.exhibits.length}`,
  );
  const robot = usePlayer((state) => state.robot);
  const language = useSettings((settings) => settings.language);
  const layers = choices(timeline, robot, language);
  const [wanted, choose] = useState<string | null>(null); // null: nobody chose yet
  const first = layers.find(({ scale }) => scale) ?? layers[0];
  const now = wanted === '' ? undefined : (layers.find(({ key }) => key === wanted) ?? first);
  const { canvas, view, intent } = useWorldCanvas(now?.chosen ?? kNothingChosen);
  const hand = useHand(view, intent);
  return (
    <section className="world" aria-label={text.panes.world}>
      <RecordingBar />
      <div className="world-frame">
        <canvas ref={canvas} role="img" aria-label={text.world.canvas} {...hand} />
        {!timeline && <p className="world-empty">{text.world.empty}</p>}
        <Tools view={view} chosen={now?.key ?? ''} layers={layers} choose={choose} />
      </div>
      {timeline && (
        <>
          <TimeBar />
          <Panels timeline={timeline} />
          <div className="world-about">
            <Spoken />
            <Hint />
            <Drives />
            <Legend timeline={timeline} />
            <Events />
          </div>
        </>
      )}
    </section>
  );
}
