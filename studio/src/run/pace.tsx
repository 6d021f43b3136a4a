import { api } from '../api/client';
import { current, useDocument } from '../state/document';
import { configure, useRun } from '../state/run';
import { complain } from '../state/workbench';
import { useText } from '../text/text';

const kPaces = [0.5, 1, 2, 5, 10, 50, 0];

/** How fast the run goes beside real time. */
export function Pace() {
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

/** Where the run is, and whether it is of what is drawn. */
export function Now() {
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
