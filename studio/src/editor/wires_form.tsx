import type { Component, Wire } from '../api/types';
import { type InputPort, inputsOf, kindOf, outputsOf } from '../state/kinds';
import { openDialog } from '../state/workbench';
import { useText } from '../text/text';
import { useSettings } from '../theme/settings';
import { Icon } from '../ui/icons';
import { change } from './change';
import { replaceWire, withPrevious } from './wiring';

function reordered(wires: Wire[], index: number, by: number): string[] {
  const order = wires.map((wire) => wire.text);
  const [moved] = order.splice(index, 1);
  order.splice(index + by, 0, moved);
  return order;
}

interface LineProps {
  component: Component;
  port: InputPort;
  wires: Wire[];
  index: number;
}

function Order({ component, port, wires, index }: LineProps) {
  const text = useText();
  const wire = wires[index];
  const shift = (by: number) =>
    change([{ op: 'reorder', id: component.id, port: port.name, order: reordered(wires, index, by) }]);
  return (
    <>
      <button
        type="button"
        className="small"
        disabled={index === 0}
        aria-label={text.inspector.earlier(wire.text)}
        onClick={() => shift(-1)}
      >
        <Icon name="up" />
      </button>
      <button
        type="button"
        className="small"
        disabled={index + 1 === wires.length}
        aria-label={text.inspector.later(wire.text)}
        onClick={() => shift(1)}
      >
        <Icon name="down" />
      </button>
    </>
  );
}

function WireLine(props: LineProps) {
  const text = useText();
  const { component, port, wires, index } = props;
  const wire = wires[index];
  return (
    <li className={wire.ok ? '' : 'has-problem'}>
      <code>{withPrevious(wire.text, false)}</code>
      <label className="check" title={text.inspector.previous_of(wire.text)}>
        <input
          type="checkbox"
          checked={wire.previous}
          disabled={!component.editable}
          aria-label={text.inspector.previous_of(withPrevious(wire.text, false))}
          onChange={() =>
            replaceWire(component.id, port.name, index, wire.text, withPrevious(wire.text, !wire.previous))
          }
        />
        <small>{text.units.previous}</small>
      </label>
      {wires.length > 1 && <Order {...props} />}
      <button
        type="button"
        className="small"
        disabled={!component.editable}
        aria-label={text.inspector.remove_wire(wire.text)}
        onClick={() => change([{ op: 'disconnect', id: component.id, port: port.name, from: wire.text }])}
      >
        <Icon name="close" />
      </button>
    </li>
  );
}

/** Every input with its wires; lists can be put in order, since the first may count most. */
export function Inputs({ component }: { component: Component }) {
  const text = useText();
  const language = useSettings((settings) => settings.language);
  const ports = inputsOf(component, kindOf(component));
  if (ports.length === 0) return null;
  return (
    <section aria-label={text.inspector.inputs}>
      <h3>{text.inspector.inputs}</h3>
      {ports.map((port) => {
        const wires = component.inputs.find((input) => input.port === port.name)?.wires ?? [];
        return (
          <div key={port.name} className="input">
            <div className="input-head" title={port.descriptor?.help[language]}>
              <span>
                <b>{port.name}</b>{' '}
                <small>
                  {text.roles[port.role] ?? port.role},{' '}
                  {port.descriptor?.required ? text.inspector.required : text.inspector.optional}
                </small>
              </span>
              <button
                type="button"
                className="small"
                disabled={!component.editable}
                aria-label={text.inspector.connect_from(port.name)}
                title={text.inspector.connect_from(port.name)}
                onClick={() => openDialog({ kind: 'connect_from', id: component.id, port: port.name })}
              >
                <Icon name="link" />
              </button>
            </div>
            <ul className="plain">
              {wires.map((wire, index) => (
                <WireLine key={wire.text} component={component} port={port} wires={wires} index={index} />
              ))}
            </ul>
          </div>
        );
      })}
    </section>
  );
}

export function Outputs({ component }: { component: Component }) {
  const text = useText();
  const ports = outputsOf(component, kindOf(component));
  if (ports.length === 0) return null;
  return (
    <section aria-label={text.inspector.outputs}>
      <h3>{text.inspector.outputs}</h3>
      <ul className="plain outputs">
        {ports.map((port) => (
          <li key={port.handle}>
            <span>
              <b>{port.label || component.id}</b>{' '}
              <small>
                {text.roles[port.role] ?? port.role} {port.unit && `[${port.unit}]`} {port.elements.join(', ')}
              </small>
            </span>
            <button
              type="button"
              className="small"
              aria-label={text.inspector.connect_to(port.label || component.id)}
              title={text.inspector.connect_to(port.label || component.id)}
              onClick={() => openDialog({ kind: 'connect_to', id: component.id, from: port.text })}
            >
              <Icon name="wired" />
            </button>
          </li>
        ))}
      </ul>
    </section>
  );
}
