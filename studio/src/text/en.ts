import { commandsEn } from './commands';
import { editorEn } from './editor';
import { filesEn } from './files';
import { pageEn } from './page';
import { reachEn } from './reach';
import { runEn } from './run';
import { tourEn } from './tour';
import { worldEn } from './world';

/** Every word of the page in English; es.ts says the same in Spanish (its type is this one's). */
export const en = {
  ...pageEn,
  ...commandsEn,
  ...filesEn,
  ...editorEn,
  ...runEn,
  ...worldEn,
  ...tourEn,
  reach: reachEn,
};

export type Dictionary = typeof en;
