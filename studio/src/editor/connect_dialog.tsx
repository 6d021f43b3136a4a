import { type ReactNode, useEffect, useState } from 'react';
import { api } from '../api/client';
import { place, useDocument, useModel } from '../state/document';
import { kindOf, outputsOf } from '../state/kinds';
import { closeDialog, complain } from '../state/workbench';
import { useText } from '../text/text';
import { Modal } from '../ui/dialog';
import { PickList } from '../ui/pick_list';
import { connectWire, withPrevious } from './wiring';

interface Choice {
  label: string;
  from: string;
  id: string;
  port: string;
  ok: boolean;
  reasons: string[];
}

function Refused({ choices }: { choices: Choice[] }) {
  const text = useText();
  if (choices.length === 0) return null;
  return (
    <details className="refused">
      <summary>{text.connect.refused(choices.length)}</summary>
      <ul className="plain">
        {choices.map((choice) => (
          <li key={choice.label}>
            <b>{choice.label}</b> <small>{choice.reasons.join(' ')}</small>
          </li>
        ))}
      </ul>
    </details>
  );
}

function Previous({ previous, set }: { previous: boolean; set(previous: boolean): void }) {
  const text = useText();
  return (
    <label className="check">
      <input type="checkbox" checked={previous} onChange={(event) => set(event.target.checked)} />{' '}
      {text.connect.previous}
    </label>
  );
}

function Choices({ choices, children }: { choices: Choice[] | null; children: ReactNode }) {
  const text = useText();
  const pick = (choice: Choice) => {
    closeDialog();
    void connectWire(choice.from, choice.id, choice.port);
  };
  return (
    <>
      <PickList
        label={text.connect.search}
        empty={choices === null ? `${text.shell.busy}…` : text.connect.nothing}
        items={(choices ?? [])
          .filter((choice) => choice.ok)
          .map((choice) => ({ key: choice.label, words: choice.label, show: choice.label, pick: () => pick(choice) }))}
      >
        {children}
      </PickList>
      <Refused choices={(choices ?? []).filter((choice) => !choice.ok)} />
    </>
  );
}

/** The keyboard's and the touch screen's way to draw a wire: from one output to any input that takes it. */
export function ConnectTo({ id, from }: { id: string; from?: string }) {
  const text = useText();
  const model = useModel();
  const { path } = useDocument();
  const component = model?.components.find((one) => one.id === id);
  const ports = component ? outputsOf(component, kindOf(component)) : [];
  const sources = ports.flatMap((port) => [
    port.text,
    ...(port.role === 'command' || component?.class === 'goal'
      ? []
      : port.elements.map((one) => `${port.text}.${one}`)),
  ]);
  const [output, setOutput] = useState(from ?? sources[0] ?? id);
  const [previous, setPrevious] = useState(false);
  const [choices, setChoices] = useState<Choice[] | null>(null);
  // biome-ignore lint/correctness/useExhaustiveDependencies: another file has other inputs
  useEffect(() => {
    const wire = withPrevious(output, previous);
    api
      .targets(place(), wire)
      .then(({ targets }) => setChoices(targets.map((one) => ({ ...one, from: wire, label: `${one.id}.${one.port}` }))))
      .catch(complain);
  }, [output, previous, path]);
  return (
    <Modal title={text.connect.to_title(output)}>
      <Choices choices={choices}>
        {sources.length > 1 && (
          <label className="field">
            <span>{text.connect.which}</span>
            <select aria-label={text.connect.which} value={output} onChange={(event) => setOutput(event.target.value)}>
              {sources.map((one) => (
                <option key={one}>{one}</option>
              ))}
            </select>
          </label>
        )}
        <Previous previous={previous} set={setPrevious} />
      </Choices>
    </Modal>
  );
}

/** The other way round: every source that one input takes. */
export function ConnectFrom({ id, port }: { id: string; port: string }) {
  const text = useText();
  const [previous, setPrevious] = useState(false);
  const [choices, setChoices] = useState<Choice[] | null>(null);
  useEffect(() => {
    api
      .sources(place(), id, port)
      .then(({ sources }) => setChoices(sources.map((one) => ({ ...one, id, port, label: one.from }))))
      .catch(complain);
  }, [id, port]);
  const shown = choices?.map((choice) => {
    const from = withPrevious(choice.from, previous || choice.from.endsWith('@previous'));
    return { ...choice, from, label: from };
  });
  return (
    <Modal title={text.connect.from_title(`${id}.${port}`)}>
      <Choices choices={shown ?? null}>
        <Previous previous={previous} set={setPrevious} />
      </Choices>
    </Modal>
  );
}
