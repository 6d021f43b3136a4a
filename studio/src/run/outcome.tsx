import { api } from '../api/client';
import { useDocument } from '../state/document';
import { openRecording } from '../state/recordings';
import { isOfDrawing, useRun } from '../state/run';
import { complain, show } from '../state/workbench';
import { useText } from '../text/text';
import { outcomeWords, verdict } from './verdict';

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
