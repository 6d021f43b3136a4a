import { player, usePlayer } from '../state/player';
import { useText } from '../text/text';
import { useSettings } from '../theme/settings';
import { interventionWords } from './reach';

const kMost = 60;

/** Goals, withdrawals and what somebody did to the world: a click goes to their time. */
export function Events() {
  const text = useText();
  const spanish = useSettings((settings) => settings.language === 'es');
  const { timeline } = usePlayer();
  if (!timeline) return null;
  const goals = timeline.goals.map((one) => ({
    t: one.time_s,
    words: text.world.goal(one.index + 1, text.world.goal_states[one.state] ?? one.state),
  }));
  const logs = timeline.logs
    .filter((one) => one.level > 2)
    .map((one) => ({
      t: one.time_s,
      words: `${text.world.loggers[one.name] ?? one.name}: ${(spanish && one.message_es) || one.message}`,
    }));
  const touches = timeline.interventions.map((one) => ({ t: one.time_s, words: interventionWords(one, text) }));
  const all = [...goals, ...logs, ...touches].sort((a, b) => b.t - a.t).slice(0, kMost);
  if (all.length === 0) return null;
  return (
    <section className="events" aria-label={text.world.events}>
      <h2>{text.world.events}</h2>
      <ul className="plain">
        {all.map((one) => (
          <li key={`${one.t} ${one.words}`}>
            <button type="button" onClick={() => player.seek(one.t)}>
              {one.words} <small>{text.world.event_at(one.t.toFixed(1))}</small>
            </button>
          </li>
        ))}
      </ul>
    </section>
  );
}
