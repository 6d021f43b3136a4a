import { commandsEs } from './commands';
import { editorEs } from './editor';
import type { Dictionary } from './en';
import { filesEs } from './files';
import { pageEs } from './page';
import { reachEs } from './reach';
import { runEs } from './run';
import { tourEs } from './tour';
import { worldEs } from './world';

/** La página en español, con las palabras de los artículos. */
export const es: Dictionary = {
  ...pageEs,
  ...commandsEs,
  ...filesEs,
  ...editorEs,
  ...runEs,
  ...worldEs,
  ...tourEs,
  reach: reachEs,
};
