import type { Outcome } from '../api/types';
import { text } from '../text/text';
import { useSettings } from '../theme/settings';

/** Whether it did its task, that nobody judged, or that somebody ended it before there could be a verdict. */
export function verdict(outcome: Outcome): { words: string; tone: 'good' | 'bad' | '' } {
  const words = text().run;
  if (outcome.success) return { words: words.success, tone: 'good' };
  if (outcome.success === null) return { words: words.not_judged, tone: '' };
  if (outcome.reason.startsWith('interrupted')) return { words: words.interrupted, tone: '' };
  return { words: words.failure, tone: 'bad' };
}

/** Why a run ended, in the language of now. */
export function outcomeWords(outcome: Outcome): string {
  const spanish = useSettings.getState().language === 'es';
  return spanish
    ? outcome.error_es || outcome.error || outcome.reason_es || outcome.reason
    : outcome.error || outcome.reason;
}
