import { api } from '../api/client';
import { current, isDirty, place, useDocument } from './document';

const kWait_ms = 800;

/** Has the server keep a draft a moment after each change, and drop it when the drawing is as on the disk again. */
export function startAutosave(failed: (error: unknown) => void): () => void {
  let timer: ReturnType<typeof setTimeout> | undefined;
  let kept = '';
  const keep = () => {
    const state = useDocument.getState();
    const what = place();
    const wanted = isDirty(state) ? `${what.path}\n${what.text}` : '';
    if (wanted === kept || state.draft) return;
    const before = kept;
    kept = wanted;
    const done = wanted
      ? api.autosave(what, state.hash)
      : before.startsWith(`${what.path}\n`) && api.discard(what.path);
    if (done) done.catch(failed);
  };
  return useDocument.subscribe((state, before) => {
    if (current(state)?.text === current(before)?.text && state.savedText === before.savedText) return;
    if (state.path !== before.path) kept = '';
    clearTimeout(timer);
    timer = setTimeout(keep, kWait_ms);
  });
}
