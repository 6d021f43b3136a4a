import type { ReactNode } from 'react';
import type { Timeline } from '../state/timeline';
import { useText } from '../text/text';

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

/** Of figure 7, and of what we draw besides: only what this run has. */
export function Legend({ timeline }: { timeline: Timeline }) {
  const { legend } = useText().world;
  const scene = timeline.scene;
  const map = timeline.maps.length > 0;
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
        {timeline.goals.length > 0 && (
          <Row mark={<circle className="w-goal" cx="14" cy="9" r="6" />} word={legend.goal} />
        )}
        {timeline.paths.length > 0 && <Row mark={<path className="w-route" d="M2 14L10 5h16" />} word={legend.route} />}
        {map && <Row mark={<path className="w-attempt" d="M2 9h24" />} word={legend.attempts} />}
        {map && <Row mark={<path className="w-inhibited" d="M8 3l12 12M20 3L8 15" />} word={legend.inhibited} />}
        {map && (
          <Row
            mark={[0, 1, 2, 3, 4, 5, 6].map((i) => (
              <rect key={i} className={`viridis-${i}`} x={4 * i} y="4" width="4" height="10" />
            ))}
            word={legend.risk}
          />
        )}
      </ul>
    </section>
  );
}
