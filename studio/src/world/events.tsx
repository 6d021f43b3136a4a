import { player, usePlayer } from '../state/player';
import { isNote, logWords } from '../text/log';
import { useText } from '../text/text';
import { useSettings } from '../theme/settings';
import { interventionWords } from './reach';

const kMost = 60;

/** What was noted, withdrawals, and what somebody did to the world: a click goes to their time. */
export function Events() {
  const text = useText();
  const language = useSettings((settings) => settings.language);
  const { timeline } = usePlayer();
  if (!timeline) return null;
  const logs = timeline.logs
    .filter((one) => one.name !== 'intervention') // told as an event of its own
    .map((one) => {
      const who = isNote(one) ? '' : `${text.world.loggers[one.name] ?? one.name}: `;
      return { t: one.time_s, words: `${who}${logWords(one, language)}` };
    });
  const touches = timeline.interventions.map((one) => ({ t: one.time_s, words: interventionWords(one, text) }));
  const all = [...logs, ...touches].sort((a, b) => b.t - a.t).slice(0, kMost);
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
