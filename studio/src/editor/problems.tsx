import type { Problem } from '../api/types';
import { select, useModel } from '../state/document';
import { openDialog, say, show, useWorkbench } from '../state/workbench';
import { useText } from '../text/text';
import { Icon } from '../ui/icons';
import { reveal } from './canvas_handle';
import { change } from './change';

function goTo(problem: Problem): void {
  if (!problem.component) return;
  select([problem.component]);
  if (useWorkbench.getState().pane === 'problems') show('properties');
  reveal(problem.component);
  say(problem.message);
}

/** What one click can mend: the key or wire the problem names, nothing guessed. */
function Fixes({ problem }: { problem: Problem }) {
  const text = useText();
  const model = useModel();
  const { component: id, port, key } = problem;
  if (!model || !id) return null;
  const component = model.components.find((one) => one.id === id);
  const wires = component?.inputs.find((input) => input.port === port)?.wires ?? [];
  const given =
    component?.parameters.some((one) => one.name === key) || component?.unknown.some((one) => one.key === key);
  return (
    <>
      {wires
        .filter((wire) => !wire.ok || wires.length === 1)
        .map((wire) => (
          <button
            key={wire.text}
            type="button"
            onClick={() => change([{ op: 'disconnect', id, port, from: wire.text }])}
          >
            {text.problems.fix_wire}
          </button>
        ))}
      {port !== '' && (
        <button type="button" onClick={() => openDialog({ kind: 'connect_from', id, port })}>
          {text.problems.fix_connect}
        </button>
      )}
      {given && (
        <button type="button" onClick={() => change([{ op: 'unset', id, key }])}>
          {text.problems.fix_default}
        </button>
      )}
    </>
  );
}

/** The message without the component's id, which stands before it anyway. */
function besides({ component, message }: Problem): string {
  const id = `${component}: `;
  return component !== '' && message.startsWith(id) ? message.slice(id.length) : message;
}

/** Everything that stands between the drawing and a run; a click goes to the culprit. */
export function Problems() {
  const text = useText();
  const model = useModel();
  const open = useWorkbench((state) => state.problemsOpen);
  const problems = model?.problems ?? [];
  if (!model) return null;
  return (
    <section className={`problems ${open ? 'open' : ''}`} aria-label={text.panes.problems}>
      <button
        type="button"
        className={`problems-head ${problems.length > 0 ? 'bad' : 'good'}`}
        aria-expanded={open}
        onClick={() => useWorkbench.setState({ problemsOpen: !open })}
      >
        <Icon name={problems.length > 0 ? 'warning' : 'check'} />
        <span aria-live="polite">
          {problems.length > 0 ? text.problems.count(problems.length) : text.problems.none}
        </span>
      </button>
      {open && (
        <ul className="plain">
          {problems.map((problem) => (
            <li key={`${problem.line} ${problem.column} ${problem.message}`}>
              <button type="button" className="problem" onClick={() => goTo(problem)}>
                <b>{problem.component || text.problems.of_all}</b> {besides(problem)}{' '}
                <small>{text.problems.line(problem.line)}</small>
              </button>
              <Fixes problem={problem} />
            </li>
          ))}
        </ul>
      )}
    </section>
  );
}
