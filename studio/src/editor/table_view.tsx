import { memo } from 'react';
import type { Component } from '../api/types';
import { select, useDocument, useModel } from '../state/document';
import { openDialog } from '../state/workbench';
import { useText } from '../text/text';
import { ClassMark, Icon } from '../ui/icons';
import { problemsPer } from './graph';

interface RowProps {
  component: Component;
  problems: number;
  selected: boolean;
}

const Row = memo(function Row({ component, problems, selected }: RowProps) {
  const text = useText();
  const wires = component.inputs.flatMap((input) => input.wires.map((wire) => `${input.port} ← ${wire.text}`));
  return (
    <tr aria-selected={selected} className={selected ? 'selected' : ''}>
      <th scope="row">
        <button type="button" aria-label={text.table.select(component.id)} onClick={() => select([component.id])}>
          {component.id}
        </button>
      </th>
      <td>
        <ClassMark of={component.class} /> {text.classes[component.class]}
      </td>
      <td>
        {component.channel || component.kind}
        {component.command && ` → ${component.command}`}
      </td>
      <td>{wires.join('; ')}</td>
      <td>{problems > 0 ? text.problems.count(problems) : ''}</td>
      <td>
        <button
          type="button"
          className="small"
          aria-label={text.inspector.connect_to(component.id)}
          onClick={() => openDialog({ kind: 'connect_to', id: component.id })}
        >
          <Icon name="wired" />
        </button>
      </td>
    </tr>
  );
});

/** The drawing as a table: for screen readers, and for whoever likes rows better. */
export function TableView() {
  const text = useText();
  const model = useModel();
  const selection = useDocument((state) => state.selection);
  if (!model) return <p className="hint">{text.files.choose}</p>;
  const selected = new Set(selection);
  const problems = problemsPer(model.problems);
  return (
    // biome-ignore lint/a11y/noNoninteractiveTabindex: a region that scrolls can be reached by the keyboard
    <section className="table-view" tabIndex={0} aria-label={text.panes.table}>
      <table>
        <caption>{text.table.caption}</caption>
        <thead>
          <tr>
            <th scope="col">{text.table.id}</th>
            <th scope="col">{text.table.class}</th>
            <th scope="col">{text.table.kind}</th>
            <th scope="col">{text.table.inputs}</th>
            <th scope="col">{text.table.problems}</th>
            <th scope="col">
              <span className="for-readers">{text.commands.connect}</span>
            </th>
          </tr>
        </thead>
        <tbody>
          {model.components.map((component) => (
            <Row
              key={component.id}
              component={component}
              problems={problems.get(component.id) ?? 0}
              selected={selected.has(component.id)}
            />
          ))}
        </tbody>
      </table>
      {model.components.length === 0 && <p className="hint">{text.table.empty}</p>}
    </section>
  );
}
