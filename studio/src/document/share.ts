/** `next`, with every part that is equal to one of `before` replaced by it: what did not change stays the same object,
 *  so that nothing is drawn anew for it and two hundred models cost little more than one. Lists of components are
 *  matched by id, since one more at the front must not make all the others look new. */
export function share<T>(before: unknown, next: T): T {
  if (Object.is(before, next)) return next;
  if (Array.isArray(next)) return shareList(Array.isArray(before) ? before : [], next) as T;
  if (typeof next !== 'object' || next === null || typeof before !== 'object' || before === null) return next;
  const old = before as Record<string, unknown>;
  const made: Record<string, unknown> = {};
  let same = Object.keys(old).length === Object.keys(next).length;
  for (const [key, value] of Object.entries(next)) {
    made[key] = share(old[key], value);
    same = same && key in old && Object.is(made[key], old[key]);
  }
  return (same ? before : made) as T;
}

function idOf(item: unknown): string | undefined {
  return (item as { id?: string } | null)?.id;
}

function shareList(before: unknown[], next: unknown[]): unknown[] {
  const byId = new Map(before.map((item) => [idOf(item), item]));
  const made = next.map((item, i) => {
    const id = idOf(item);
    return share(id === undefined ? before[i] : byId.get(id), item);
  });
  return made.length === before.length && made.every((item, i) => Object.is(item, before[i])) ? before : made;
}
