import { type ReactNode, useEffect, useId, useRef, useState } from 'react';

export interface Pick {
  key: string;
  /** What typing looks through. */
  words: string;
  show: ReactNode;
  note?: ReactNode;
  pick(): void;
}

interface Props {
  label: string;
  items: Pick[];
  empty: string;
  children?: ReactNode;
}

const kMost = 400;

/** A list to type in and choose from: arrows, Enter, or a click. */
export function PickList({ label, items, empty, children }: Props) {
  const id = useId();
  const [words, setWords] = useState('');
  const [at, setAt] = useState(0);
  const list = useRef<HTMLDivElement>(null);
  const wanted = words.toLowerCase().split(/\s+/).filter(Boolean);
  const found = items.filter((item) => wanted.every((word) => item.words.toLowerCase().includes(word))).slice(0, kMost);
  const chosen = Math.min(at, found.length - 1);
  useEffect(() => {
    list.current?.children[chosen]?.scrollIntoView({ block: 'nearest' });
  }, [chosen]);
  return (
    <div className="pick-list">
      <input
        type="text"
        role="combobox"
        aria-expanded="true"
        aria-controls={`${id}list`}
        aria-activedescendant={chosen >= 0 ? `${id}${chosen}` : undefined}
        aria-autocomplete="list"
        autoComplete="off"
        placeholder={label}
        aria-label={label}
        value={words}
        onChange={(event) => {
          setWords(event.target.value);
          setAt(0);
        }}
        onKeyDown={(event) => {
          if (!['ArrowDown', 'ArrowUp', 'Enter'].includes(event.key)) return;
          event.preventDefault();
          if (event.key === 'Enter') found[chosen]?.pick();
          else setAt(Math.max(0, Math.min(found.length - 1, chosen + (event.key === 'ArrowDown' ? 1 : -1))));
        }}
      />
      {children}
      <div className="options" ref={list} role="listbox" id={`${id}list`} aria-label={label}>
        {found.map((item, i) => (
          // biome-ignore lint/a11y/useKeyWithClickEvents: keys are the text field's, as a combobox has it
          // biome-ignore lint/a11y/useFocusableInteractive: the text field keeps the focus and points here
          <div key={item.key} id={`${id}${i}`} role="option" aria-selected={i === chosen} onClick={item.pick}>
            <span>{item.show}</span>
            {item.note && <small>{item.note}</small>}
          </div>
        ))}
      </div>
      {found.length === 0 && <p className="hint">{empty}</p>}
    </div>
  );
}
