import { api, type Target } from '../api/client';
import { edit, place } from '../state/document';
import { complain, say, toast } from '../state/workbench';
import { text } from '../text/text';

const kPrevious = '@previous';

export function isPrevious(from: string): boolean {
  return from.endsWith(kPrevious);
}

export function withPrevious(from: string, previous: boolean): string {
  const plain = isPrevious(from) ? from.slice(0, -kPrevious.length) : from;
  return previous ? plain + kPrevious : plain;
}

/** Draws a wire where the checks allow it: as asked for, else as the value of the previous tick, else it says why not. */
export async function connectWire(from: string, id: string, port: string): Promise<boolean> {
  try {
    const asked = await api.mayConnect(place(), from, id, port);
    let wire = from;
    if (!asked.ok) {
      const later = withPrevious(from, true);
      const previous = later === from ? asked : await api.mayConnect(place(), later, id, port);
      if (!previous.ok) {
        toast(`${text().connect.refused_toast}: ${from} → ${id}.${port}`, asked.reasons ?? [], 'bad');
        return false;
      }
      wire = later;
      toast(text().connect.as_previous);
    }
    await edit([{ op: 'connect', from: wire, id, port }]);
    say(text().connect.done(wire, `${id}.${port}`));
    return true;
  } catch (error) {
    complain(error);
    return false;
  }
}

/** Another source in a wire's stead, at its place in the list. */
export async function replaceWire(id: string, port: string, index: number, old: string, by: string): Promise<void> {
  try {
    await edit([
      { op: 'disconnect', id, port, from: old },
      { op: 'connect', from: by, id, port, index },
    ]);
  } catch (error) {
    complain(error);
  }
}

/** What the wire in the hand fits, asked for once when it is taken up. */
export class Offer {
  private fits = new Map<string, Target>();
  private known = false;

  constructor(readonly from: string) {
    Promise.all([api.targets(place(), from), api.targets(place(), withPrevious(from, true))])
      .then(([now, before]) => {
        for (const target of [...now.targets, ...before.targets]) {
          const key = `${target.id}.${target.port}`;
          if (!this.fits.get(key)?.ok) this.fits.set(key, target.ok ? target : (this.fits.get(key) ?? target));
        }
        this.known = true;
      })
      .catch(complain);
  }

  /** Until the answer is there everything may be tried: the checks decide again when it is let go. */
  allows(id: string, port: string): boolean {
    return !this.known || this.fits.get(`${id}.${port}`)?.ok === true;
  }

  reasons(id: string, port: string): string[] {
    return this.fits.get(`${id}.${port}`)?.reasons ?? [];
  }
}
