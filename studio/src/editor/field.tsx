import { useEffect, useId, useRef, useState } from 'react';
import type { ParameterDescriptor, Value } from '../api/types';
import { numberOf, shown } from '../text/numbers';
import { useText } from '../text/text';
import { useSettings } from '../theme/settings';
import { Icon } from '../ui/icons';

const isText = (type: ParameterDescriptor['type']) => type === 'word' || type === 'file';

function parsed(words: string, type: ParameterDescriptor['type']): Value | null {
  if (isText(type) || type === 'choice') return words;
  if (type !== 'reals') return numberOf(words);
  const numbers = words
    .split(/[\s;]+/)
    .filter(Boolean)
    .map(numberOf);
  return numbers.some((number) => number === null) ? null : (numbers as number[]);
}

interface Props {
  parameter: ParameterDescriptor;
  value: Value | undefined;
  problem: string | undefined;
  disabled: boolean;
  set(value: Value): void;
  unset(): void;
}

function TextInput({ id, about, given, ...props }: Props & { id: string; about: string; given: Value }) {
  const text = useText();
  const [words, setWords] = useState(shown(given));
  const [bad, setBad] = useState(false);
  const sent = useRef<string | null>(null); // under way: leaving the field does not send it again
  useEffect(() => {
    setWords(shown(given));
    setBad(false);
    sent.current = null;
  }, [given]);
  /** Enter writes a default out too, so that the file says it. */
  const commit = (pinned: boolean) => {
    if (words === shown(given) && !(pinned && props.value === undefined)) return setBad(false);
    if (words === sent.current) return;
    const value = parsed(words, props.parameter.type);
    setBad(value === null);
    if (value === null) return;
    sent.current = words;
    props.set(value);
  };
  return (
    <>
      <input
        id={id}
        value={words}
        disabled={props.disabled}
        aria-describedby={about}
        aria-invalid={bad || props.problem !== undefined}
        inputMode={isText(props.parameter.type) ? 'text' : 'decimal'}
        onChange={(event) => setWords(event.target.value)}
        onBlur={() => commit(false)}
        onKeyDown={(event) => {
          if (event.key === 'Enter') commit(true);
          if (event.key === 'Escape') setWords(shown(given));
        }}
      />
      {bad && <span className="bad">{text.inspector.bad_number}</span>}
    </>
  );
}

function Choice({ id, about, given, ...props }: Props & { id: string; about: string; given: Value }) {
  const text = useText();
  const boolean = props.parameter.type === 'boolean';
  const options = boolean ? ['true', 'false'] : (props.parameter.choices ?? []);
  const word = (option: string) => (boolean ? (option === 'true' ? text.inspector.yes : text.inspector.no) : option);
  return (
    <select
      id={id}
      value={shown(given)}
      disabled={props.disabled}
      aria-describedby={about}
      onChange={(event) => props.set(boolean ? event.target.value === 'true' : event.target.value)}
    >
      {options.map((option) => (
        <option key={option} value={option}>
          {word(option)}
        </option>
      ))}
    </select>
  );
}

/** One parameter, as its descriptor says: unit, range, default, help; "back" removes it from the file. */
export function Field(props: Props) {
  const text = useText();
  const language = useSettings((settings) => settings.language);
  const { parameter, value } = props;
  const id = useId();
  const about = `${id}about`;
  const given = value ?? parameter.default;
  const range =
    parameter.min !== undefined && parameter.max !== undefined
      ? text.inspector.range(shown(parameter.min), shown(parameter.max))
      : '';
  const Control = parameter.type === 'boolean' || parameter.type === 'choice' ? Choice : TextInput;
  return (
    <div className={`field ${value === undefined ? 'is-default' : ''} ${props.problem ? 'has-problem' : ''}`}>
      <label htmlFor={id}>
        {parameter.name}
        {parameter.unit && parameter.unit !== '*' && <small> [{parameter.unit}]</small>}
      </label>
      <div className="field-row">
        <Control {...props} id={id} about={about} given={given} />
        {value !== undefined && !props.disabled && (
          <button
            type="button"
            className="small"
            aria-label={`${parameter.name}: ${text.inspector.back}`}
            title={text.inspector.back}
            onClick={props.unset}
          >
            <Icon name="reset" />
          </button>
        )}
      </div>
      <small id={about}>
        {parameter.help[language]}. {range && `${range}, `}
        {text.inspector.default(shown(parameter.default))}
        {parameter.ours && ` (${text.inspector.ours})`}
      </small>
      {props.problem && <span className="bad">{props.problem}</span>}
    </div>
  );
}
