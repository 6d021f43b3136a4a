import { api } from '../api/client';
import { patiently } from '../api/presence';
import { current, isDirty, place, useDocument } from '../state/document';

const kWait_ms = 800;

/** Has the server keep a draft a moment after each change, and drop it when the drawing is as on the disk again. A server
 *  that is away gets the newest one when it is back. */
export function startAutosave(failed: (error: unknown) => void): () => void {
  let timer: ReturnType<typeof setTimeout> | undefined;
  let kept = '';
  let turn: Promise<unknown> = Promise.resolve();
  const keep = () => {
    const state = useDocument.getState();
    const what = place();
    const wanted = isDirty(state) ? `${what.path}\n${what.text}` : '';
    if (wanted === kept || state.draft) return;
    const before = kept;
    kept = wanted;
    const send = (): Promise<unknown> => {
      if (kept !== wanted) return Promise.resolve();
      if (wanted) return api.autosave(what, state.hash);
      return before.startsWith(`${what.path}\n`) ? api.discard(what.path) : Promise.resolve();
    };
    turn = turn
      .then(() => patiently(send))
      .catch((error) => {
        if (kept === wanted) kept = '';
        failed(error);
      });
  };
  return useDocument.subscribe((state, before) => {
    if (current(state)?.text === current(before)?.text && state.savedText === before.savedText) return;
    if (state.path !== before.path) kept = '';
    clearTimeout(timer);
    timer = setTimeout(keep, kWait_ms);
  });
}
