/** Where something stands in the text. It changes with every line above it and is shown of problems only, so what
 *  differs in nothing else counts as the same. */
const kPlaces: ReadonlySet<string> = new Set(['line', 'column']);
const kProblems = 'problems';

/** Equal in all but places in the text; with `placed` in those too. */
export function isSame(before: unknown, next: unknown, placed = false): boolean {
  if (Object.is(before, next)) return true;
  if (typeof before !== 'object' || typeof next !== 'object' || before === null || next === null) return false;
  if (Array.isArray(next)) {
    if (!Array.isArray(before) || before.length !== next.length) return false;
    for (let i = 0; i < next.length; i += 1) if (!isSame(before[i], next[i], placed)) return false;
    return true;
  }
  const [old, made] = [before as Record<string, unknown>, next as Record<string, unknown>];
  for (const key in made) {
    if (!(key in old)) return false;
    if (!placed && kPlaces.has(key)) continue;
    if (!isSame(old[key], made[key], placed || key === kProblems)) return false;
  }
  return Object.keys(old).length === Object.keys(made).length;
}

/** `next`, with every part that is equal to one of `before` replaced by it: what did not change stays the same object,
 *  so that nothing is drawn anew for it and two hundred models cost little more than one. Lists of components are
 *  matched by id, since one more at the front must not make all the others look new. `placed`: of problems the line
 *  counts too. */
export function share<T>(before: unknown, next: T, placed = false): T {
  if (isSame(before, next, placed)) return before as T;
  if (Array.isArray(next)) return shareList(Array.isArray(before) ? before : [], next, placed) as T;
  if (typeof next !== 'object' || next === null || typeof before !== 'object' || before === null) return next;
  const old = before as Record<string, unknown>;
  const made: Record<string, unknown> = {};
  for (const [key, value] of Object.entries(next)) made[key] = share(old[key], value, placed || key === kProblems);
  return made as T;
}

function idOf(item: unknown): string | undefined {
  return (item as { id?: string } | null)?.id;
}

function shareList(before: unknown[], next: unknown[], placed: boolean): unknown[] {
  const byId = new Map(before.map((item) => [idOf(item), item]));
  return next.map((item, i) => {
    const id = idOf(item);
    return share(id === undefined ? before[i] : byId.get(id), item, placed);
  });
}
