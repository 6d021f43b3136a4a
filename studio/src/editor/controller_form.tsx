import { memo, useEffect, useState } from 'react';
import type { Model } from '../api/types';
import { edit } from '../state/document';
import { complain } from '../state/workbench';
import { numberOf, rounded, shown } from '../text/numbers';
import { useText } from '../text/text';

function Text({ label, value, commit }: { label: string; value: string; commit(words: string): void }) {
  const [words, setWords] = useState(value);
  useEffect(() => setWords(value), [value]);
  const done = () => words !== value && commit(words);
  return (
    <label className="field">
      <span>{label}</span>
      <input
        value={words}
        onChange={(event) => setWords(event.target.value)}
        onBlur={done}
        onKeyDown={(event) => event.key === 'Enter' && done()}
      />
    </label>
  );
}

/** The robot's self-description: what a controller can feel and do. */
export const RobotCard = memo(function RobotCard({ robot }: { robot: Model['robot'] }) {
  const text = useText();
  if (!robot.known) return <p className="hint">{text.palette.no_robot}</p>;
  return (
    <section aria-label={text.inspector.robot_says}>
      <h2>{text.inspector.robot_says}</h2>
      <p>
        <b>{robot.name}</b> <small>{robot.path}</small>
      </p>
      <h3>{text.inspector.channels}</h3>
      <ul className="plain small-print">
        {robot.channels.map((channel) => (
          <li key={channel.name}>
            <code>{channel.name}</code> {channel.unit && `[${channel.unit}]`} {channel.elements.join(', ')}
          </li>
        ))}
      </ul>
      <h3>{text.inspector.robot_commands}</h3>
      <ul className="plain small-print">
        {robot.commands.map((command) => (
          <li key={command.name}>
            <code>{command.name}</code>:{' '}
            {command.elements
              .map((one) =>
                [one.name, text.inspector.range(rounded(one.min), rounded(one.max)), one.unit && `[${one.unit}]`]
                  .filter(Boolean)
                  .join(' '),
              )
              .join('; ')}
          </li>
        ))}
      </ul>
    </section>
  );
});

/** What belongs to the whole controller. */
export function ControllerForm({ model }: { model: Model }) {
  const text = useText();
  const set = (key: string, value: string | number) => edit([{ op: 'set', id: '', key, value }]).catch(complain);
  return (
    <>
      <p className="hint">{text.inspector.nothing}</p>
      <Text label={text.inspector.name} value={model.name} commit={(name) => set('name', name)} />
      <Text
        label={`${text.inspector.tick_s} [s]`}
        value={model.tick_s > 0 ? shown(model.tick_s) : ''}
        commit={(words) => {
          const tick = numberOf(words);
          if (tick !== null) set('tick_s', tick);
          else if (words.trim() === '') edit([{ op: 'unset', id: '', key: 'tick_s' }]).catch(complain);
        }}
      />
      {model.robot.path !== '' && (
        <p className="hint">
          {text.inspector.robot}: <code>{model.robot.path}</code>
        </p>
      )}
      <RobotCard robot={model.robot} />
    </>
  );
}
