import { usePresence } from '../api/presence';
import { discardDraft, overwrite, putOffConflict, recoverDraft, takeFromDisk } from '../state/disk';
import { useDocument } from '../state/document';
import { complain } from '../state/workbench';
import { useText } from '../text/text';

/** What must be decided before going on calmly: a draft to recover, a file that changed on the disk. */
export function Banners() {
  const text = useText();
  const draft = useDocument((state) => state.draft);
  const conflict = useDocument((state) => state.conflict);
  const hash = useDocument((state) => state.hash);
  const busy = useDocument((state) => state.busy);
  const { connected, strange } = usePresence();
  const act = (work: () => Promise<unknown>) => () => work().catch(complain);
  return (
    <div className="banners" role="status">
      {!connected && (
        <p className="banner bad offline">
          <b>{text.shell.not_connected}</b> {strange ? text.shell.strange : text.shell.offline}{' '}
          {busy > 0 && text.shell.waiting(busy)}
        </p>
      )}
      {draft && (
        <div className="banner">
          <p>
            {text.save.draft_found} {draft.basedOn !== hash && text.save.draft_older}
          </p>
          <button type="button" className="primary" onClick={act(recoverDraft)}>
            {text.save.recover}
          </button>
          <button type="button" onClick={act(discardDraft)}>
            {text.save.discard}
          </button>
        </div>
      )}
      {conflict && (
        <div className="banner bad">
          <p>{conflict.gone ? text.save.gone : text.save.conflict}</p>
          <button type="button" onClick={act(overwrite)}>
            {text.save.overwrite}
          </button>
          {!conflict.gone && (
            <button type="button" onClick={act(takeFromDisk)}>
              {text.save.take}
            </button>
          )}
          <button type="button" onClick={putOffConflict}>
            {text.save.later}
          </button>
        </div>
      )}
    </div>
  );
}
