import { useText } from '../text/text';
import { goTo, useDocument } from './document';

/** Every step so far; a click goes there. */
export function HistoryPane() {
  const text = useText();
  const steps = useDocument((state) => state.steps);
  const now = useDocument((state) => state.now);
  const words = text.history.steps as Record<string, string>;
  return (
    <section aria-label={text.panes.history}>
      <p className="hint">{text.history.title}</p>
      <ol className="plain history" reversed>
        {steps
          .map((step, i) => (
            <li key={`${step.at_ms} ${step.about} ${step.text.length}`}>
              <button type="button" aria-current={i === now ? 'step' : undefined} onClick={() => goTo(i)}>
                {words[step.step] ?? text.history.opened} <small>{step.about}</small>
                {i === now && <small>{text.history.now}</small>}
              </button>
            </li>
          ))
          .reverse()}
      </ol>
    </section>
  );
}
