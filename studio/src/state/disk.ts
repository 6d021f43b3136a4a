import { ApiError, api } from '../api/client';
import { patiently } from '../api/presence';
import { begin, type Conflict, inTurn, isDirty, place, replaceText, settled, useDocument } from './document';

// What is between the drawing and its file: opening, saving, drafts, and files that change beneath it.
const { getState: get, setState: set } = useDocument;

export async function openDocument(path: string): Promise<void> {
  const file = await api.openFile(path);
  const draft = file.draft && file.draft.text !== file.text ? file.draft : null;
  await begin(path, {
    savedText: file.text,
    hash: file.hash,
    draft: draft ? { text: draft.text, basedOn: draft.based_on } : null,
  });
}

/** true: saved. false: the file is another by now, and `conflict` says so. */
export function save(): Promise<boolean> {
  return inTurn(async () => {
    const what = place();
    try {
      const { hash } = await patiently(() => api.save(what, get().hash));
      set({ savedText: what.text, hash, draft: null, conflict: null });
      return true;
    } catch (error) {
      if (!(error instanceof ApiError) || error.code !== 'Conflict') throw error;
      const conflict = conflictOf(error.details);
      if (conflict.text === what.text && !conflict.gone) {
        // it was saved, and the server ended before it could say so
        set({ savedText: what.text, hash: conflict.hash, draft: null, conflict: null });
        return true;
      }
      set({ conflict });
      return false;
    }
  });
}

function conflictOf(details: Record<string, unknown>): Conflict {
  const hash = typeof details.hash === 'string' ? details.hash : '';
  return { hash, text: typeof details.text === 'string' ? details.text : '', gone: hash === '' };
}

export function overwrite(): Promise<boolean> {
  const conflict = get().conflict;
  set({ conflict: null, hash: conflict?.hash ?? '' });
  return save();
}

export async function takeFromDisk(): Promise<void> {
  const file = await api.openFile(get().path);
  await replaceText(file.text);
  await api.discard(get().path);
  set({ savedText: file.text, hash: file.hash, conflict: null, draft: null });
}

export async function recoverDraft(): Promise<void> {
  const draft = get().draft;
  if (!draft) return;
  await replaceText(draft.text);
  set({ draft: null });
}

export async function discardDraft(): Promise<void> {
  await api.discard(get().path);
  set({ draft: null });
}

export type DiskChange = 'same' | 'reloaded' | 'conflict';

/** What to do when the file changed on the disk: an unchanged drawing follows, a changed one asks. */
export async function fileChanged(path: string, hash: string): Promise<DiskChange> {
  await settled();
  const state = get();
  if (path !== state.path || hash === state.hash) return 'same';
  if (hash === '') {
    set({ conflict: { hash: '', text: '', gone: true } });
    return 'conflict';
  }
  const file = await api.openFile(path);
  if (file.hash === get().hash) return 'same';
  if (!isDirty()) {
    await replaceText(file.text);
    set({ savedText: file.text, hash: file.hash });
    return 'reloaded';
  }
  set({ conflict: { hash: file.hash, text: file.text, gone: false } });
  return 'conflict';
}

export function putOffConflict(): void {
  set({ conflict: null });
}
