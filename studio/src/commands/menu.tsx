import { useEffect, useRef, useState } from 'react';
import { useText } from '../text/text';
import { Icon } from '../ui/icons';
import { carryOut, kCommands } from './commands';

const kMenus = ['file', 'edit', 'view', 'run', 'help'] as const;

/** All commands by menu, made of the one table. */
export function Menu() {
  const text = useText();
  const [open, setOpen] = useState(false);
  const root = useRef<HTMLDivElement>(null);
  useEffect(() => {
    if (!open) return;
    const leave = (event: Event) => !root.current?.contains(event.target as Node) && setOpen(false);
    addEventListener('pointerdown', leave);
    return () => removeEventListener('pointerdown', leave);
  }, [open]);
  return (
    // biome-ignore lint/a11y/noStaticElementInteractions: Escape closes the menu wherever the focus is inside
    <div
      className="menu"
      ref={root}
      onKeyDown={(event) => {
        if (event.key !== 'Escape') return;
        setOpen(false);
        root.current?.querySelector('button')?.focus();
      }}
    >
      <button type="button" aria-expanded={open} aria-label={text.shell.menu} onClick={() => setOpen(!open)}>
        <Icon name="menu" />
      </button>
      {open && (
        <div className="menu-sheet">
          {kMenus.map((menu) => (
            <section key={menu} aria-label={text.menus[menu]}>
              <h2>{text.menus[menu]}</h2>
              {kCommands
                .filter((command) => command.menu === menu)
                .map((command) => (
                  <button
                    key={command.name}
                    type="button"
                    disabled={!(command.enabled?.() ?? true)}
                    onClick={() => {
                      setOpen(false);
                      void carryOut(command);
                    }}
                  >
                    {text.commands[command.name]} {command.keys && <kbd>{command.keys[0]}</kbd>}
                  </button>
                ))}
            </section>
          ))}
        </div>
      )}
    </div>
  );
}
