import { type PointerEvent, useEffect, useRef, useState } from 'react';
import { closeRecording, useRun } from '../run/run';
import { useText } from '../text/text';
import { onColours } from '../theme/settings';
import { Icon } from '../ui/icons';
import { MapPainter } from './draw_map';
import { poseAt } from './draw_robot';
import { Drives } from './drives';
import { Events } from './events';
import { Legend } from './legend';
import { paintWorld } from './paint';
import { player, usePlayer } from './player';
import { TimeBar } from './time_bar';
import { View, worldColours } from './view';

const kZoomStep = 1.3;

/** Wheel, drag and pinch of one canvas. */
function useHand(view: { current: View | null }) {
  const pointers = useRef(new Map<number, [number, number]>());
  const down = (event: PointerEvent<HTMLCanvasElement>) => {
    pointers.current.set(event.pointerId, [event.clientX, event.clientY]);
    event.currentTarget.setPointerCapture(event.pointerId);
  };
  const move = (event: PointerEvent) => {
    const before = pointers.current.get(event.pointerId);
    if (!before || !view.current) return;
    const others = [...pointers.current].filter(([id]) => id !== event.pointerId);
    const now: [number, number] = [event.clientX, event.clientY];
    if (others.length === 0) view.current.panBy(now[0] - before[0], now[1] - before[1]);
    else {
      const [, other] = others[0];
      const apart = (at: [number, number]) => Math.hypot(at[0] - other[0], at[1] - other[1]);
      view.current.zoomBy(apart(now) / (apart(before) || 1));
    }
    pointers.current.set(event.pointerId, now);
    player.wake();
  };
  const up = (event: PointerEvent) => pointers.current.delete(event.pointerId);
  return { onPointerDown: down, onPointerMove: move, onPointerUp: up, onPointerCancel: up };
}

function useWorldCanvas(layer: string) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const view = useRef<View | null>(null);
  useEffect(() => {
    const element = canvas.current;
    if (!element) return;
    view.current = view.current ?? new View(element);
    const seen = view.current;
    const painter = new MapPainter();
    let colours = worldColours();
    const paint = player.addPainter((timeline, t, robot) =>
      paintWorld(seen, painter, timeline, t, robot, layer, colours),
    );
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
  return { canvas, view };
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

/** The world of the run that is looked at, live or recorded, with its time. */
export function World() {
  const text = useText();
  const timeline = usePlayer((state) => state.timeline);
  // Maps, routes and goals come to a run that goes on: the timeline stays the same object.
  usePlayer(({ timeline: one }) => one && `${one.maps.length} ${one.paths.length} ${one.goals.length}`);
  const layers = timeline?.maps[0]?.layers ?? [];
  const [layer, setLayer] = useState('label');
  const { canvas, view } = useWorldCanvas(layer);
  const hand = useHand(view);
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
            <Drives />
            <Legend timeline={timeline} />
            <Events />
          </div>
        </>
      )}
    </section>
  );
}
