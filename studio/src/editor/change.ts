import type { Operation } from '../api/types';
import { edit } from '../state/document';
import { complain } from '../state/workbench';

/** Edits as a field or button does it: nobody waits for it, and what is refused is told. */
export function change(operations: Operation[], merge?: string): void {
  edit(operations, { merge }).catch(complain);
}
