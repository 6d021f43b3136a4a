import { useEffect, useRef, useState } from 'react';
import { player, usePlayer } from '../state/player';
import { closeRecording } from '../state/recordings';
import { useRun } from '../state/run';
import { useText } from '../text/text';
import { onColours } from '../theme/settings';
import { Icon } from '../ui/icons';
import { drawIntent } from './draw_intent';
import { MapPainter } from './draw_map';
import { poseAt } from './draw_robot';
import { Drives } from './drives';
import { Events } from './events';
import { useHand } from './hand';
import { Legend } from './legend';
import { paintWorld } from './paint';
import { type Intent, mayPutObstacle, maySetGoal } from './reach';
import { TimeBar } from './time_bar';
import { View, worldColours } from './view';

const kZoomStep = 1.3;

function useWorldCanvas(layer: string) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const view = useRef<View | null>(null);
  const intent = useRef<Intent>({ cell: null, ghost: null });
  useEffect(() => {
    const element = canvas.current;
    if (!element) return;
    view.current = view.current ?? new View(element);
    const seen = view.current;
    const painter = new MapPainter();
    let colours = worldColours();
    const paint = player.addPainter((timeline, t, robot) => {
      paintWorld(seen, painter, timeline, t, robot, layer, colours);
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
  }, [layer]);
  return { canvas, view, intent };
}

function Tools({
  view,
  layer,
  layers,
  setLayer,
}: {
  view: { current: View | null };
  layer: string;
  layers: string[];
  setLayer(layer: string): void;
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
          {text.world.map}{' '}
          <select value={layer} onChange={(event) => setLayer(event.target.value)}>
            {['', ...layers].map((one) => (
              <option key={one} value={one}>
                {one === '' ? text.world.no_map : (text.world.layers[one] ?? one)}
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
  // Maps, routes and goals come to a run that goes on: the timeline stays the same object.
  usePlayer(({ timeline: one }) => one && `${one.maps.length} ${one.paths.length} ${one.goals.length}`);
  const layers = timeline?.maps[0]?.layers ?? [];
  const [layer, setLayer] = useState('label');
  const { canvas, view, intent } = useWorldCanvas(layer);
  const hand = useHand(view, intent);
  return (
    <section className="world" aria-label={text.panes.world}>
      <RecordingBar />
      <div className="world-frame">
        <canvas ref={canvas} role="img" aria-label={text.world.canvas} {...hand} />
        {!timeline && <p className="world-empty">{text.world.empty}</p>}
        <Tools view={view} layer={layer} layers={layers} setLayer={setLayer} />
      </div>
      {timeline && (
        <>
          <TimeBar />
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
