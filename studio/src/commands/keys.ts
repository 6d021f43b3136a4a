import { useWorkbench } from '../state/workbench';
import { type Command, carryOut, kCommands } from './commands';

/** How a key event is written in the table: "Ctrl+Shift+Z", "F5", "?". */
export function keyName(event: Pick<KeyboardEvent, 'key' | 'ctrlKey' | 'metaKey' | 'shiftKey' | 'altKey'>): string {
  const named = event.key === ' ' ? 'Space' : event.key.length === 1 ? event.key.toUpperCase() : event.key;
  const letter = /^[A-Z]$/.test(named) || named.length > 1;
  const parts = [
    (event.ctrlKey || event.metaKey) && 'Ctrl',
    event.altKey && 'Alt',
    event.shiftKey && letter && 'Shift',
    named,
  ];
  return parts.filter(Boolean).join('+');
}

const kTyping = 'input:not([type=checkbox]):not([type=range]), textarea, select, [contenteditable]';
const kOwnEnds = 'button, summary, a, [role=option], input[type=checkbox]';

function belongsToPage(event: KeyboardEvent, name: string): boolean {
  const target = event.target instanceof Element ? event.target : null;
  if (useWorkbench.getState().dialog !== null) return false;
  if (target?.closest(kTyping)) return name === 'Ctrl+S' || name === 'Ctrl+K' || name === 'F5';
  return !(name === 'Space' && target?.closest(kOwnEnds));
}

export function commandFor(name: string): Command | undefined {
  return kCommands.find((command) => command.keys?.includes(name));
}

/** Keys of the whole page; what is typed into fields and dialogs stays theirs. */
export function listenToKeys(): () => void {
  const listen = (event: KeyboardEvent) => {
    const name = keyName(event);
    const onCanvas = event.target instanceof Element && event.target.classList.contains('canvas');
    const command = name === 'Tab' && onCanvas && !event.shiftKey && tabAdds() ? commandFor('A') : commandFor(name);
    if (!command || !belongsToPage(event, name)) return;
    if (command.name === 'copy' && String(getSelection()) !== '') return;
    event.preventDefault();
    void carryOut(command);
  };
  addEventListener('keydown', listen);
  return () => removeEventListener('keydown', listen);
}

/** Tab on an empty drawing adds; on others it leaves the drawing, so that nobody is caught in it. */
function tabAdds(): boolean {
  return document.querySelector('.canvas-empty') !== null;
}
