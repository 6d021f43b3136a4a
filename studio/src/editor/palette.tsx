import { useState } from 'react';
import type { ComponentClass } from '../api/types';
import { useModel } from '../state/document';
import { useKinds } from '../state/kinds';
import { complain } from '../state/workbench';
import { useText } from '../text/text';
import { useSettings } from '../theme/settings';
import { ClassMark } from '../ui/icons';
import { add, type Offered, offered } from './adding';
import { kDragType } from './canvas';
import { middle } from './canvas_handle';

const kClasses: ComponentClass[] = ['goal', 'sensation', 'sensing', 'acting', 'coordinator'];

/** Those whose name, paper's name or help has every word. */
export function search(all: Offered[], words: string, className: (name: string) => string): Offered[] {
  const wanted = words.toLowerCase().split(/\s+/).filter(Boolean);
  return all.filter((one) => {
    const hay = `${one.label} ${one.paper} ${one.help} ${className(one.class)}`.toLowerCase();
    return wanted.every((word) => hay.includes(word));
  });
}

function Entry({ one }: { one: Offered }) {
  return (
    <li>
      <button
        type="button"
        className={`offer class-${one.class}`}
        draggable
        title={one.help}
        data-offer={one.label}
        onDragStart={(event) => event.dataTransfer.setData(kDragType, JSON.stringify(one))}
        onClick={() => add(one, middle()).catch(complain)}
      >
        <ClassMark of={one.class as ComponentClass} />
        <span>
          <b>{one.label}</b>
          {one.paper && <small> ({one.paper})</small>}
          <small className="offer-help">{one.help}</small>
        </span>
      </button>
    </li>
  );
}

/** Everything there is to add, by class. */
export function Palette() {
  const text = useText();
  const model = useModel();
  const kinds = useKinds((state) => state.list);
  const language = useSettings((settings) => settings.language);
  const [words, setWords] = useState('');
  const found = search(offered(kinds, model, language), words, (name) => text.classes[name as ComponentClass]);
  if (!model) return <p className="hint">{text.files.choose}</p>;
  return (
    <div className="palette">
      <input
        type="search"
        value={words}
        placeholder={text.palette.search}
        aria-label={text.palette.search}
        onChange={(event) => setWords(event.target.value)}
      />
      <p className="hint">{text.palette.hint}</p>
      {kClasses.map((name) => {
        const list = found.filter((one) => one.class === name);
        return (
          <section key={name} aria-label={text.classes[name]}>
            <h2 className={`class-${name}`}>
              <ClassMark of={name} />
              {text.classes[name]}
            </h2>
            {name === 'sensation' && !model.robot.known && <p className="hint">{text.palette.no_robot}</p>}
            <ul>
              {list.map((one) => (
                <Entry key={`${one.class} ${one.label}`} one={one} />
              ))}
            </ul>
          </section>
        );
      })}
      {found.length === 0 && <p className="hint">{text.palette.nothing}</p>}
    </div>
  );
}
