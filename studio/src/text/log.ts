import type { Language, LogEvent } from '../api/types';

/** What a line of the log says in a language; files of before have it in English only. */
export function logWords(event: LogEvent, language: Language): string {
  return (language === 'es' && event.message_es) || event.message;
}

const kNote = 2; // level of foxglove.Log

/** No warning, and not told as an event of its own besides. */
export function isNote(event: LogEvent): boolean {
  return event.level <= kNote && event.name !== 'intervention';
}
