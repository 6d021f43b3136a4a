import { create } from 'zustand';
import { ApiError } from './client';

interface Presence {
  connected: boolean;
  /** The server answers, but does not know this page: it was started anew. */
  strange: boolean;
}

export const usePresence = create<Presence>(() => ({ connected: true, strange: false }));

export function present(): void {
  usePresence.setState({ connected: true, strange: false });
}

export function absent(): void {
  usePresence.setState({ connected: false });
}

const kRetry_ms = 400;

function isAway(error: unknown): error is ApiError {
  return error instanceof ApiError && (error.code === 'Unreachable' || error.code === 'Unauthorized');
}

/** Does what may be done twice, however long the server is away. */
export async function patiently<T>(work: () => Promise<T>): Promise<T> {
  for (let away = false; ; away = true) {
    try {
      const result = await work();
      if (away) present();
      return result;
    } catch (error) {
      if (!isAway(error)) throw error;
      usePresence.setState({ connected: false, strange: error.code === 'Unauthorized' });
      await new Promise((resolve) => setTimeout(resolve, kRetry_ms));
    }
  }
}
