import { Handle, type NodeProps, Position } from '@xyflow/react';
import { memo } from 'react';
import type { InputPort, OutputPort } from '../state/kinds';
import { kindOf } from '../state/kinds';
import { toggleExpanded } from '../state/workbench';
import { useText } from '../text/text';
import { useSettings } from '../theme/settings';
import { ClassMark, Icon } from '../ui/icons';
import type { ComponentNode } from './graph';

function Input({ port, wired, bad }: { port: InputPort; wired: boolean; bad: boolean }) {
  const text = useText();
  const language = useSettings((settings) => settings.language);
  const required = port.descriptor?.required ? ` (${text.inspector.required})` : '';
  const help = port.descriptor
    ? `${text.roles[port.role] ?? port.role}: ${port.descriptor.help[language]}${required}`
    : '';
  const state = bad ? 'bad' : wired ? 'wired' : required ? 'open' : 'free';
  return (
    <div className="port port-in" title={help}>
      <Handle
        id={`i:${port.name}`}
        type="target"
        position={Position.Left}
        className={`handle role-${port.role} ${state}`}
      />
      <span>{port.name}</span>
    </div>
  );
}

function Output({ port }: { port: OutputPort }) {
  const text = useText();
  const unit = port.unit ? ` [${port.unit}]` : '';
  return (
    <div className="port port-out" title={`${text.roles[port.role] ?? port.role}${unit}`}>
      <span>{port.label || (port.unit && `[${port.unit}]`)}</span>
      <Handle
        id={`o:${port.handle}`}
        type="source"
        position={Position.Right}
        className={`handle role-${port.role} wired`}
      />
    </div>
  );
}

function Box({ data, selected }: NodeProps<ComponentNode>) {
  const text = useText();
  const { component, ports, problems } = data;
  const kind = kindOf(component);
  const what = component.channel || component.kind;
  const wired = new Map(component.inputs.map((input) => [input.port, input.wires]));
  return (
    <div className={`box class-${component.class} ${selected ? 'selected' : ''}`} data-component={component.id}>
      <div className="box-head">
        <ClassMark of={component.class} />
        <div className="box-names">
          <b>{component.id}</b>
          <small>
            {kind?.paper_name ? `${what} (${kind.paper_name})` : what || text.classes[component.class]}
            {component.command && <em> → {component.command}</em>}
          </small>
        </div>
        {problems > 0 && (
          <span className="box-problems" title={text.problems.count(problems)}>
            <Icon name="warning" />
            {problems}
          </span>
        )}
      </div>
      <div className="box-ports">
        <div>
          {ports.inputs.map((port) => (
            <Input
              key={port.name}
              port={port}
              wired={(wired.get(port.name)?.length ?? 0) > 0}
              bad={wired.get(port.name)?.some((wire) => !wire.ok) ?? false}
            />
          ))}
        </div>
        <div>
          {ports.outputs.map((port) => (
            <Output key={port.handle} port={port} />
          ))}
          {ports.foldable && (
            <button
              type="button"
              className="port port-more nodrag"
              tabIndex={-1}
              aria-expanded={data.expanded}
              onClick={() => toggleExpanded(component.id)}
            >
              {data.expanded ? text.inspector.fewer_outputs : text.inspector.more_outputs(ports.hidden)}
            </button>
          )}
        </div>
      </div>
    </div>
  );
}

export const ComponentBox = memo(Box);
