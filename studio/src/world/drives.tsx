import { usePlayer } from '../state/player';
import type { Timeline } from '../state/timeline';
import { useText } from '../text/text';

interface Candidate {
  id: string;
  state: 'driving' | 'suppressed' | 'silent';
  share: number;
}

/** Who drives at a time: the candidates of each coordinator; without one, the modules that are active. */
export function candidatesAt(timeline: Timeline, robot: number, t: number): Candidate[] {
  const value = (column: string) => timeline.value(robot, column, t);
  const coordinated = (timeline.info?.coordinators ?? []).flatMap((coordinator) =>
    coordinator.candidates.map((id, index): Candidate => {
      const share = value(`${coordinator.id}.share.${id}`);
      const driving = value(`${coordinator.id}.active`) === index || share > 0;
      const suppressed = value(`${coordinator.id}.suppressed.${id}`) === 1;
      return { id, state: driving ? 'driving' : suppressed ? 'suppressed' : 'silent', share: share || 0 };
    }),
  );
  if (coordinated.length > 0) return coordinated;
  const columns = timeline.robots[robot]?.columns.keys() ?? [];
  return [...columns]
    .filter((column) => column.endsWith('.active'))
    .map((column) => {
      const active = value(column) === 1;
      return { id: column.replace('.active', ''), state: active ? 'driving' : 'silent', share: active ? 1 : 0 };
    });
}

export function Drives() {
  const text = useText();
  const { timeline, t, robot } = usePlayer();
  if (!timeline) return null;
  const candidates = candidatesAt(timeline, robot, t);
  if (candidates.length === 0) return null;
  return (
    <section className="drives" aria-label={text.world.drives}>
      <h2>{text.world.drives}</h2>
      <ul className="plain">
        {candidates.map((one, index) => (
          <li key={one.id} className={`drives-${one.state} look-${index % 8}`}>
            <b>{one.id}</b> <span>{text.world[one.state]}</span>
          </li>
        ))}
      </ul>
    </section>
  );
}
