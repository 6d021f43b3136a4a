import { beforeEach, describe, expect, test, vi } from 'vitest';
import { usePresence } from '../src/api/presence';
import type { Model } from '../src/api/types';
import { startAutosave } from '../src/document/autosave';
import { fileChanged, openDocument, overwrite, recoverDraft, save } from '../src/state/disk';
import { current, edit, isDirty, kept, redo, select, undo, useDocument } from '../src/state/document';
import { share } from '../src/state/share';
import { StubServer } from './stub';

let server: StubServer;
const texts = () => current()?.text.split('\n').filter(Boolean);
const add = (id: string, merge?: string) => edit([{ op: 'add', class: 'sensing', kind: 'K', id }], { merge });

beforeEach(async () => {
  server = new StubServer();
  server.install();
  server.files.set('a.toml', 'one\ntwo');
  await openDocument('a.toml');
});

describe('a document', () => {
  test('undoes two hundred steps and does them again', async () => {
    for (let i = 0; i < 200; i += 1) await add(`c${i}`);
    expect(texts()).toHaveLength(202);
    for (let i = 0; i < 200; i += 1) await undo();
    expect(texts()).toEqual(['one', 'two']);
    for (let i = 0; i < 200; i += 1) await redo();
    expect(texts()).toHaveLength(202);
  });

  test('carries out edits that overlap one after the other', async () => {
    await Promise.all([add('a'), add('b'), add('c')]);
    expect(texts()).toEqual(['one', 'two', 'a', 'b', 'c']);
  });

  test('keeps edits while the server is away, shows that, and sends them in order when it is back', async () => {
    const back = globalThis.fetch;
    globalThis.fetch = () => Promise.reject(new TypeError('no server'));
    const waiting = [add('a'), add('b')];
    await vi.waitFor(() => expect(usePresence.getState().connected).toBe(false));
    expect(useDocument.getState().busy).toBe(2);
    globalThis.fetch = back;
    await Promise.all(waiting);
    expect(texts()).toEqual(['one', 'two', 'a', 'b']);
    expect(usePresence.getState().connected).toBe(true);
  });

  test('takes a file that holds the very text as saved: the server ended before it could say so', async () => {
    await add('a');
    server.files.set('a.toml', current()?.text ?? '');
    expect(await save()).toBe(true);
    expect(isDirty()).toBe(false);
  });

  test('makes one step of key presses that follow each other', async () => {
    await add('a', 'nudge');
    await add('b', 'nudge');
    expect(useDocument.getState().steps).toHaveLength(2);
    await undo();
    expect(texts()).toEqual(['one', 'two']);
  });

  test('forgets what was undone when another edit comes', async () => {
    await add('a');
    await undo();
    await add('b');
    await redo();
    expect(texts()).toEqual(['one', 'two', 'b']);
  });

  test('keeps only what is still there selected', async () => {
    select(['one', 'two']);
    await edit([{ op: 'remove', ids: ['one'] }]);
    expect(useDocument.getState().selection).toEqual(['two']);
  });

  test('keeps the objects of components that an edit leaves alone', async () => {
    const before = current()?.model.components[1];
    await edit([{ op: 'rename', id: 'one', to: 'first' }]);
    expect(current()?.model.components[1]).toBe(before);
  });
});

describe('the history', () => {
  const model = { name: '', tick_s: 0, components: [], problems: [], runnable: true } as unknown as Model;
  const steps = (count: number, length: number) => {
    const text = 'x'.repeat(length);
    return Array.from({ length: count }, (_, i) => ({ text, model, step: `${i}`, about: '', merge: '', at_ms: 0 }));
  };

  test('keeps a thousand steps of small texts, the newest', () => {
    expect(kept(steps(5, 10))).toHaveLength(5);
    const all = kept(steps(1005, 10));
    expect([all.length, all[0].step, all.at(-1)?.step]).toEqual([1000, '5', '1004']);
  });

  test('keeps fewer of large texts, but always two hundred', () => {
    expect(kept(steps(700, 100_000))).toHaveLength(640);
    expect(kept(steps(700, 1_000_000))).toHaveLength(200);
  });
});

describe('what an edit leaves alone', () => {
  test('stays the same object though its lines have moved on', () => {
    const at = (line: number) => ({
      components: [{ id: 'a', line, inputs: [{ port: 'in', wires: [{ text: 'b', line }] }] }],
    });
    const before = at(3);
    expect(share(before, at(4))).toBe(before);
  });

  test('of problems the line counts', () => {
    const at = (line: number) => ({ components: [], problems: [{ message: 'no', line }] });
    expect(share(at(3), at(4)).problems[0].line).toBe(4);
  });
});

describe('saving', () => {
  test('clears the dirty mark, and undo sets it again', async () => {
    await add('a');
    expect(isDirty()).toBe(true);
    expect(await save()).toBe(true);
    expect(isDirty()).toBe(false);
    await undo();
    expect(isDirty()).toBe(true);
  });

  test('stops at a file that another has changed, and overwrites it only when told to', async () => {
    await add('a');
    server.files.set('a.toml', 'theirs');
    expect(await save()).toBe(false);
    expect(server.files.get('a.toml')).toBe('theirs');
    expect(useDocument.getState().conflict?.text).toBe('theirs');
    expect(await overwrite()).toBe(true);
    expect(server.files.get('a.toml')).toBe('one\ntwo\na');
  });

  test('follows a change on the disk while nothing is unsaved', async () => {
    server.files.set('a.toml', 'theirs');
    expect(await fileChanged('a.toml', 'theirs')).toBe('reloaded');
    expect(texts()).toEqual(['theirs']);
    await undo();
    expect(texts()).toEqual(['one', 'two']);
  });

  test('asks when the file changed under an unsaved drawing', async () => {
    await add('a');
    server.files.set('a.toml', 'theirs');
    expect(await fileChanged('a.toml', 'theirs')).toBe('conflict');
    expect(texts()).toEqual(['one', 'two', 'a']);
  });
});

describe('drafts', () => {
  test('are kept a moment after a change and dropped once it is undone', async () => {
    vi.useFakeTimers();
    const stop = startAutosave(() => undefined);
    await add('a');
    await vi.advanceTimersByTimeAsync(1000);
    expect(server.drafts.get('a.toml')?.text).toBe('one\ntwo\na');
    await undo();
    await vi.advanceTimersByTimeAsync(1000);
    expect(server.drafts.has('a.toml')).toBe(false);
    stop();
    vi.useRealTimers();
  });

  test('are offered, and recovering one is a step that can be undone', async () => {
    server.drafts.set('a.toml', { text: 'one\ntwo\nlost', based_on: 'one\ntwo' });
    await openDocument('a.toml');
    expect(texts()).toEqual(['one', 'two']);
    await recoverDraft();
    expect(texts()).toEqual(['one', 'two', 'lost']);
    await undo();
    expect(texts()).toEqual(['one', 'two']);
  });
});
