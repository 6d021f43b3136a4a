import { useEffect } from 'react';
import { carryOut, commandOf } from '../commands/commands';
import { fit } from '../editor/canvas_handle';
import { edit, useModel } from '../state/document';
import { useRun } from '../state/run';
import { complain, say, useWorkbench } from '../state/workbench';
import { useText } from '../text/text';
import { Icon } from '../ui/icons';
import { kTour } from './steps';

/** The first run: rebuilds figure 6 step by step, watching the drawing to see what is done. */
export function Tour() {
  const text = useText();
  const model = useModel();
  const at = useWorkbench((state) => state.tour) ?? 0;
  const step = kTour[at];
  const done = model ? step.done(model) : false;
  const ended = useRun(
    ({ state }) => step.name === 'run' && state?.state === 'done' && !!state.outcome && state.outcome.success !== false,
  );
  useEffect(() => {
    if (done && at + 1 < kTour.length) useWorkbench.setState({ tour: at + 1 });
  }, [done, at]);
  useEffect(() => say(text.tour.steps[step.name]), [step, text]);
  const close = () => useWorkbench.setState({ tour: null });
  const show = () => {
    if (step.name === 'file') return carryOut(commandOf('new'));
    if (step.name === 'run') return carryOut(commandOf('run'));
    return edit(model ? step.operations(model) : []).then(() => requestAnimationFrame(fit), complain);
  };
  return (
    <section className="tour" aria-label={text.panes.tour}>
      <div className="dialog-head">
        <h2>{text.tour.title}</h2>
        <button type="button" aria-label={text.tour.finish} title={text.tour.finish} onClick={close}>
          <Icon name="close" />
        </button>
      </div>
      {at === 0 && <p className="hint">{text.tour.intro}</p>}
      <progress max={kTour.length} value={ended ? kTour.length : at} aria-hidden />
      {ended ? (
        <p className="good">{text.tour.ended}</p>
      ) : (
        <p aria-current="step">
          <span className="hint">{text.tour.progress(at + 1, kTour.length)}</span> <b>{text.tour.steps[step.name]}</b>
        </p>
      )}
      {ended ? (
        <button type="button" className="primary" onClick={close}>
          {text.tour.finish}
        </button>
      ) : (
        <button type="button" className="primary" onClick={show}>
          {step.name === 'run' ? text.commands.run : step.name === 'file' ? text.commands.new : text.tour.show}
        </button>
      )}
    </section>
  );
}
