import type { Component, Model } from '../api/types';
import { useDocument, useModel } from '../state/document';
import { kindOf, useKinds } from '../state/kinds';
import { openDialog } from '../state/workbench';
import { useText } from '../text/text';
import { useSettings } from '../theme/settings';
import { ClassMark } from '../ui/icons';
import { change } from './change';
import { ControllerForm } from './controller_form';
import { Field } from './field';
import { Inputs, Outputs } from './wires_form';

interface SelectProps {
  label: string;
  value: string;
  options: [string, string][];
  disabled: boolean;
  pick(value: string): void;
}

function Select({ label, value, options, disabled, pick }: SelectProps) {
  const all = options.some(([one]) => one === value) ? options : [[value, value] as [string, string], ...options];
  return (
    <label className="field">
      <span>{label}</span>
      <select aria-label={label} value={value} disabled={disabled} onChange={(event) => pick(event.target.value)}>
        {all.map(([one, word]) => (
          <option key={one} value={one}>
            {word}
          </option>
        ))}
      </select>
    </label>
  );
}

/** What a component is and whom it drives. */
function Identity({ component, model }: { component: Component; model: Model }) {
  const text = useText();
  const kinds = useKinds((state) => state.list);
  const kind = kindOf(component);
  const { id, editable } = component;
  const set = (key: string) => (value: string) =>
    change([value === '' ? { op: 'unset', id, key } : { op: 'set', id, key, value }]);
  const drives = kind?.ports.some((port) => port.direction === 'out' && port.role === 'command');
  const commands = model.robot.commands.map((command): [string, string] => [command.name, command.name]);
  return (
    <>
      <div className="field">
        <span>{text.inspector.id}</span>
        <button type="button" disabled={!editable} onClick={() => openDialog({ kind: 'rename', id })}>
          {id}
        </button>
      </div>
      {component.class === 'sensation' ? (
        <Select
          label={text.inspector.channel}
          value={component.channel}
          options={model.robot.channels.map((channel) => [channel.name, channel.name])}
          disabled={!editable}
          pick={set('channel')}
        />
      ) : (
        <Select
          label={text.inspector.kind}
          value={component.kind}
          options={kinds.filter((one) => one.class === component.class).map((one) => [one.name, one.name])}
          disabled={!editable}
          pick={set('kind')}
        />
      )}
      {(drives || component.command !== '') && (
        <Select
          label={text.inspector.command}
          value={component.command}
          options={[['', text.inspector.no_command], ...commands]}
          disabled={!editable}
          pick={set('command')}
        />
      )}
    </>
  );
}

function Parameters({ component, model }: { component: Component; model: Model }) {
  const text = useText();
  const kind = kindOf(component);
  if (!kind || kind.parameters.length === 0) return null;
  const given = new Map(component.parameters.map((one) => [one.name, one.value]));
  const problems = model.problems.filter((problem) => problem.component === component.id);
  return (
    <section aria-label={text.inspector.parameters}>
      <h3>{text.inspector.parameters}</h3>
      {kind.parameters.map((parameter) => (
        <Field
          key={parameter.name}
          parameter={parameter}
          value={given.get(parameter.name)}
          problem={problems.find((problem) => problem.key === parameter.name)?.message}
          disabled={!component.editable}
          set={(value) => change([{ op: 'set', id: component.id, key: parameter.name, value }])}
          unset={() => change([{ op: 'unset', id: component.id, key: parameter.name }])}
        />
      ))}
    </section>
  );
}

function One({ component, model }: { component: Component; model: Model }) {
  const text = useText();
  const language = useSettings((settings) => settings.language);
  const kind = kindOf(component);
  return (
    <>
      <h2 className={`class-${component.class}`}>
        <ClassMark of={component.class} /> {component.id} <small>{text.classes[component.class]}</small>
      </h2>
      {kind && (
        <p className="hint">
          {kind.summary[language]}
          {kind.source !== 'ours' && language === 'en' && (
            <small>
              {' '}
              {text.inspector.source}: {kind.source}
            </small>
          )}
        </p>
      )}
      {!component.editable && <p className="hint">{text.inspector.frozen}</p>}
      <Identity component={component} model={model} />
      <Inputs component={component} />
      <Outputs component={component} />
      <Parameters component={component} model={model} />
      {component.unknown.length > 0 && (
        <section>
          <h3>{text.inspector.unknown}</h3>
          {component.unknown.map((one) => (
            <pre key={one.key}>
              {one.key} = {one.text}
            </pre>
          ))}
        </section>
      )}
    </>
  );
}

/** Properties of what is selected, or of the whole. */
export function Inspector() {
  const text = useText();
  const model = useModel();
  const selection = useDocument((state) => state.selection);
  if (!model) return <p className="hint">{text.files.choose}</p>;
  const chosen = model.components.filter((component) => selection.includes(component.id));
  if (chosen.length === 1) return <One key={chosen[0].id} component={chosen[0]} model={model} />;
  if (chosen.length > 1) {
    return (
      <>
        <p>{text.inspector.many(chosen.length)}</p>
        <ul className="plain">
          {chosen.map((component) => (
            <li key={component.id}>
              <ClassMark of={component.class} /> {component.id}
            </li>
          ))}
        </ul>
      </>
    );
  }
  return <ControllerForm model={model} />;
}
