import { CommandButton } from '../commands/command_button';
import { Now, Pace } from '../run/pace';
import { useModel } from '../state/document';
import { useRun } from '../state/run';
import { useText } from '../text/text';

/** Run, and what becomes of it. The number on Run is that of the problems before it. */
export function RunBar() {
  const text = useText();
  const problems = useModel()?.problems.length ?? 0;
  const state = useRun((run) => run.state);
  const going = state?.state === 'running' || state?.state === 'paused' || state?.state === 'armed';
  return (
    <div className="run-bar" role="toolbar" aria-label={text.menus.run}>
      <CommandButton name="configure" icon="gear" />
      {going ? (
        <CommandButton name="pause" icon={state.state === 'running' ? 'pause' : 'play'} />
      ) : (
        <span className="run-button">
          <CommandButton name="run" icon="play" words={problems > 0 ? text.run.blocked(problems) : text.commands.run} />
          {problems > 0 && <span className="count">{problems}</span>}
        </span>
      )}
      <CommandButton name="step" icon="step" />
      <CommandButton name="stop" icon="stop" />
      <CommandButton name="reset" icon="reset" />
      <Pace />
      <Now />
      {state?.attached && <small>{text.run.attached}</small>}
    </div>
  );
}
