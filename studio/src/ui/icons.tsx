import type { ComponentClass } from '../api/types';

// Drawn here: glyphs of fonts are not there on every machine.
const kPaths: Record<string, string> = {
  play: 'M6 4l14 8-14 8z',
  pause: 'M6 4h4v16H6zM14 4h4v16h-4z',
  stop: 'M5 5h14v14H5z',
  step: 'M5 4l10 8-10 8zM16 4h3v16h-3z',
  reset: 'M5 4h3v7l9-7v16l-9-7v7H5z',
  close: 'M5 7l2-2 5 5 5-5 2 2-5 5 5 5-2 2-5-5-5 5-2-2 5-5z',
  up: 'M12 6l8 9-2 2-6-7-6 7-2-2z',
  down: 'M12 18l8-9-2-2-6 7-6-7-2 2z',
  plus: 'M10 4h4v6h6v4h-6v6h-4v-6H4v-4h6z',
  minus: 'M4 10h16v4H4z',
  menu: 'M3 5h18v3H3zM3 11h18v3H3zM3 17h18v3H3z',
  gear: 'M10 2h4l1 3 3-1 2 3-2 2v3l2 2-2 3-3-1-1 3h-4l-1-3-3 1-2-3 2-2V9L4 7l2-3 3 1zM12 9a3 3 0 100 6 3 3 0 000-6z',
  undo: 'M8 4L2 10l6 6v-4h6a4 4 0 010 8h-3v3h3a7 7 0 000-14H8z',
  redo: 'M16 4l6 6-6 6v-4h-6a4 4 0 000 8h3v3h-3a7 7 0 010-14h6z',
  save: 'M4 3h13l4 4v14H3V3zM7 5v5h9V5zM7 14v6h10v-6z',
  link: 'M4 6a3 3 0 116 1l5 7a3 3 0 11-2 1L8 8a3 3 0 01-4-2z',
  warning: 'M12 2l11 19H1zM11 9v6h2V9zM11 17v2h2v-2z',
  check: 'M4 12l3-3 4 4 8-8 3 3-11 11z',
  fit: 'M3 3h7v3H6v4H3zM14 3h7v7h-3V6h-4zM3 14h3v4h4v3H3zM18 14h3v7h-7v-3h4z',
  wired: 'M3 10h13l-4-4 2-2 8 8-8 8-2-2 4-4H3z',
};

export function Icon({ name }: { name: string }) {
  return (
    <svg className="icon" viewBox="0 0 24 24" aria-hidden="true" focusable="false">
      <path d={kPaths[name]} fillRule="evenodd" />
    </svg>
  );
}

const kShapes: Record<ComponentClass, string> = {
  goal: 'M12 1l11 11-11 11L1 12z',
  sensation: 'M12 1.5a10.5 10.5 0 110 21 10.5 10.5 0 010-21z',
  sensing: 'M12 2l11 20H1z',
  acting: 'M2 2h20v20H2z',
  coordinator: 'M6.5 2h11L23 12l-5.5 10h-11L1 12z',
};

/** A class is told by colour, shape and word: this is the first two. */
export function ClassMark({ of }: { of: ComponentClass }) {
  return (
    <svg className={`mark mark-${of}`} viewBox="0 0 24 24" aria-hidden="true" focusable="false">
      <path d={kShapes[of]} />
    </svg>
  );
}
