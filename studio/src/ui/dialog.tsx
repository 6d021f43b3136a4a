import { type ReactNode, useEffect, useRef } from 'react';
import { closeDialog } from '../state/workbench';
import { useText } from '../text/text';
import { Icon } from './icons';

/** A modal of the browser's own: focus stays inside, Escape closes, and goes back where it was. */
export function Modal({ title, children, wide }: { title: string; children: ReactNode; wide?: boolean }) {
  const text = useText();
  const element = useRef<HTMLDialogElement>(null);
  useEffect(() => {
    const before = document.activeElement as HTMLElement | null;
    element.current?.showModal();
    element.current?.querySelector<HTMLElement>('[data-first], input, select')?.focus();
    return () => before?.focus?.();
  }, []);
  return (
    // biome-ignore lint/a11y/useKeyWithClickEvents: Escape is the dialog's own; this is the click beside it
    <dialog
      ref={element}
      className={wide ? 'wide' : ''}
      aria-label={title}
      onCancel={closeDialog}
      onClose={closeDialog}
      onClick={(event) => event.target === element.current && closeDialog()}
    >
      <div className="dialog-head">
        <h2>{title}</h2>
        <button type="button" aria-label={text.shell.close} onClick={closeDialog}>
          <Icon name="close" />
        </button>
      </div>
      {children}
    </dialog>
  );
}
