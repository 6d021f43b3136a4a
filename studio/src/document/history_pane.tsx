import { memo } from 'react';
import { goTo, useDocument } from '../state/document';
import { useText } from '../text/text';

interface EntryProps {
  index: number;
  words: string;
  about: string;
  now: boolean;
}

const Entry = memo(function Entry({ index, words, about, now }: EntryProps) {
  const text = useText();
  return (
    <li>
      <button type="button" aria-current={now ? 'step' : undefined} onClick={() => goTo(index)}>
        {words} <small>{about}</small>
        {now && <small>{text.history.now}</small>}
      </button>
    </li>
  );
});

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
            <Entry
              // biome-ignore lint/suspicious/noArrayIndexKey: a step's place in the history is what it is known by
              key={`${i} ${step.at_ms}`}
              index={i}
              words={words[step.step] ?? text.history.opened}
              about={step.about}
              now={i === now}
            />
          ))
          .reverse()}
      </ol>
    </section>
  );
}
