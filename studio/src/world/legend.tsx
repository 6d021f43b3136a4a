import type { ReactNode } from 'react';
import { kForms, roleLook } from '../api/exhibits';
import { isSeen } from '../state/frames';
import { usePlayer } from '../state/player';
import type { Timeline } from '../state/timeline';
import { useText } from '../text/text';
import { isDark, useSettings } from '../theme/settings';

function Row({ mark, word }: { mark: ReactNode; word: string }) {
  return (
    <li>
      <svg viewBox="0 0 28 18" className="legend-mark" aria-hidden="true" focusable="false">
        {mark}
      </svg>
      {word}
    </li>
  );
}

function shapeMark(form: number, role: string): ReactNode {
  const look = roleLook(role);
  const colour = look[isDark() ? 'dark' : 'light'];
  const line = { stroke: colour, strokeWidth: 2.2, strokeDasharray: look.dash.join(' '), fill: 'none' };
  const filled = look.filled && !look.over ? { fill: colour, stroke: '#22272e' } : line;
  if (form === kForms.disc) return <circle cx="14" cy="9" r="6" {...filled} />;
  if (form === kForms.polygon) return <path d="M6 3h16v12H6z" {...filled} />;
  if (form === kForms.sector) return <path d="M3 9L25 2a24 24 0 010 14z" {...line} />;
  if (form === kForms.point) return <circle cx="14" cy="9" r="4" fill={colour} />;
  return <path d="M2 9h24" {...line} />;
}

/** One row for each role and form that is shown now or was before, in the words of the roles. */
function ShapeRows({ timeline, robot }: { timeline: Timeline; robot: number }) {
  const language = useSettings((settings) => settings.language);
  const seen = new Map<string, { form: number; role: string }>();
  for (const { of, track } of timeline.exhibits) {
    if (of.form !== 'marks' || !isSeen(of, robot)) continue;
    for (const { shapes } of track.values) {
      for (const { form, role } of shapes ?? []) {
        if (form !== kForms.label) seen.set(`${role} ${form}`, { form, role });
      }
    }
  }
  return [...seen.entries()].map(([key, { form, role }]) => (
    <Row key={key} mark={shapeMark(form, role)} word={roleLook(role)[language]} />
  ));
}

const kSteps = [0, 1, 2, 3, 4, 5, 6];

/** Scales, and classes that have a sign or are painted. */
function FieldRows({ timeline, robot }: { timeline: Timeline; robot: number }) {
  const text = useText();
  const language = useSettings((settings) => settings.language);
  const layers = timeline.fields
    .filter(({ of, track }) => isSeen(of, robot) && track.words && track.words.frame !== '')
    .flatMap(({ of, track }) =>
      (track.words?.layers ?? []).map((layer) => ({ key: `${of.name} ${layer.name}`, layer })),
    );
  return layers.map(({ key, layer }) =>
    layer.classes.length > 0 ? (
      layer.classes.map((one) => (
        <Row key={`${key} ${one.byte}`} mark={shapeMark(kForms.polygon, one.role)} word={one.title[language]} />
      ))
    ) : (
      <Row
        key={key}
        mark={kSteps.map((i) => <rect key={i} className={`viridis-${i}`} x={4 * i} y="4" width="4" height="10" />)}
        word={text.world.legend.scale(layer.title[language], layer.low, layer.high, layer.unit)}
      />
    ),
  );
}

/** Of figure 7, and of what we draw besides: only what this run has. */
export function Legend({ timeline }: { timeline: Timeline }) {
  const robot = usePlayer((state) => state.robot);
  const { legend } = useText().world;
  const scene = timeline.scene;
  const sonar = timeline.info?.robots[0]?.sensors.some((sensor) => sensor.max_range_m > 0);
  const furniture = scene?.shapes.some((shape) => shape.class === 'furniture');
  return (
    <section className="legend" aria-label={legend.title}>
      <h2>{legend.title}</h2>
      <ul className="plain">
        <Row mark={<path className="w-body" d="M4 4h14l6 5-6 5H4z" />} word={legend.robot} />
        <Row mark={<circle className="w-start" cx="14" cy="9" r="6" />} word={legend.start} />
        <Row mark={<path className="w-trail" d="M2 9h22M18 4l7 5-7 5" />} word={legend.trail} />
        <Row mark={<path className="w-wall" d="M2 9h24" />} word={legend.wall} />
        {furniture && <Row mark={<path className="w-free" d="M6 2h16v14H6z" />} word={legend.static} />}
        {(scene?.movers.length ?? 0) > 0 && (
          <Row mark={<path className="w-mover" d="M6 2h16v14H6z" />} word={legend.dynamic} />
        )}
        {sonar && (
          <Row
            mark={<path className="w-sonar" d="M3 9L25 2a24 24 0 010 14zM14 5.6a12 12 0 010 7" />}
            word={legend.sonar}
          />
        )}
        <ShapeRows timeline={timeline} robot={robot} />
        <FieldRows timeline={timeline} robot={robot} />
      </ul>
    </section>
  );
}
