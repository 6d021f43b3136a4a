import { useSettings } from '../theme/settings';
import { type Dictionary, en } from './en';
import { es } from './es';

const kDictionaries = { en, es };

/** The page's words in the language of now. */
export function useText(): Dictionary {
  return kDictionaries[useSettings((settings) => settings.language)];
}

export function text(): Dictionary {
  return kDictionaries[useSettings.getState().language];
}
