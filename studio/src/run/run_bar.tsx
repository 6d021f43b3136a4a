import { api } from '../api/client';
import { type CommandName, carryOut, commandOf } from '../commands/commands';
import { current, useDocument, useModel } from '../state/document';
import { useText } from '../text/text';
import { Icon } from '../ui/icons';
import { complain, show } from '../state/workbench';
import { configure, isOfDrawing, openRecording, outcomeWords, useRun, verdict } from './run';

const kPaces = [0.5, 1, 2, 5, 10, 50, 0];

function Act({ name, icon, words }: { name: CommandName; icon: string; words?: string }) {
  const text = useText();
  const command = commandOf(name);
  const keys = command.keys ? ` (${command.keys[0]})` : '';
  const label = words ?? text.commands[name];
  return (
    <button
      type="button"
      aria-label={label}
      title={label + keys}
      disabled={!(command.enabled?.() ?? true)}
      onClick={() => void carryOut(command)}
    >
      <Icon name={icon} />
    </button>
  );
}

function Pace() {
  const text = useText();
  const pace = useRun((state) => state.configuration.pace);
  const state = useRun((state) => state.state?.state);
  const set = (value: number) => {
    configure({ pace: value });
    if (state && state !== 'idle') api.pace(value).catch(complain);
  };
  return (
    <label>
      <span className="for-readers">{text.run.pace}</span>
      <select value={pace} title={text.run.pace} onChange={(event) => set(Number(event.target.value))}>
        {kPaces.map((one) => (
          <option key={one} value={one}>
            {one === 0 ? text.run.fastest : text.run.times(`${one}`)}
          </option>
        ))}
      </select>
    </label>
  );
}

function Now() {
  const text = useText();
  const state = useRun((run) => run.state);
  const runText = useRun((run) => run.runText);
  const drawn = useDocument((document) => current(document)?.text);
  if (!state || state.state === 'idle') return <span className="run-now">{text.run.states.idle}</span>;
  const other = drawn !== undefined && runText !== '' && drawn !== runText;
  return (
    <span className="run-now" data-run={state.run} title={other ? text.run.runs_other : text.run.runs_same}>
      <b className={`state-${state.state}`}>{text.run.states[state.state]}</b>{' '}
      {text.run.time(state.time_s.toFixed(1), state.duration_s.toFixed(0))}
      {state.state === 'running' && state.speed > 0 && <small> {text.run.speed(state.speed.toPrecision(2))}</small>}
    </span>
  );
}

/** What became of the run that is over: why, its report, and the way to look at it again. */
export function Outcome() {
  const text = useText();
  const state = useRun((run) => run.state);
  const path = useDocument((document) => document.path);
  const mine = useRun((run) => isOfDrawing(run, path));
  const outcome = state?.state === 'done' ? state.outcome : null;
  if (!outcome || !mine) return null;
  const { words, tone } = verdict(outcome);
  return (
    <div className={`outcome ${tone}`} role="status">
      {words} <small>{outcomeWords(outcome)}</small>
      {outcome.file && (
        <>
          <a href={api.reportUrl(outcome.file)} target="_blank" rel="noreferrer">
            {text.run.report}
          </a>
          <button type="button" onClick={() => openRecording(outcome.file).then(() => show('world'), complain)}>
            {text.run.replay}
          </button>
        </>
      )}
    </div>
  );
}

/** Run, and what becomes of it. The number on Run is that of the problems before it. */
export function RunBar() {
  const text = useText();
  const problems = useModel()?.problems.length ?? 0;
  const state = useRun((run) => run.state);
  const going = state?.state === 'running' || state?.state === 'paused' || state?.state === 'armed';
  return (
    <div className="run-bar" role="toolbar" aria-label={text.menus.run}>
      <Act name="configure" icon="gear" />
      {going ? (
        <Act name="pause" icon={state.state === 'running' ? 'pause' : 'play'} />
      ) : (
        <span className="run-button">
          <Act name="run" icon="play" words={problems > 0 ? text.run.blocked(problems) : text.commands.run} />
          {problems > 0 && <span className="count">{problems}</span>}
        </span>
      )}
      <Act name="step" icon="step" />
      <Act name="stop" icon="stop" />
      <Act name="reset" icon="reset" />
      <Pace />
      <Now />
      {state?.attached && <small>{text.run.attached}</small>}
    </div>
  );
}
