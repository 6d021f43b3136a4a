import { create } from 'zustand';
import { speak } from '../api/client';
import type { Language } from '../api/types';

export type Theme = 'auto' | 'light' | 'dark';

interface Settings {
  language: Language;
  theme: Theme;
  setLanguage(language: Language): void;
  setTheme(theme: Theme): void;
}

/** What this browser keeps from visit to visit; "" = nothing. */
export function kept(key: string): string {
  try {
    return localStorage.getItem(`ganglion.${key}`) ?? '';
  } catch {
    return '';
  }
}

export function keep(key: string, value: string): void {
  try {
    localStorage.setItem(`ganglion.${key}`, value);
  } catch {
    // A browser that keeps nothing: the choice lasts as long as the page.
  }
}

function firstLanguage(): Language {
  const language = kept('language') || (typeof navigator === 'undefined' ? 'en' : navigator.language);
  return language.startsWith('es') ? 'es' : 'en';
}

function firstTheme(): Theme {
  const theme = kept('theme');
  return theme === 'light' || theme === 'dark' ? theme : 'auto';
}

export const useSettings = create<Settings>((set) => ({
  language: firstLanguage(),
  theme: firstTheme(),
  setLanguage: (language) => {
    keep('language', language);
    set({ language });
  },
  setTheme: (theme) => {
    keep('theme', theme);
    set({ theme });
  },
}));

/** Is the page dark now? */
export function isDark(): boolean {
  const { theme } = useSettings.getState();
  return theme === 'auto' ? matchMedia('(prefers-color-scheme: dark)').matches : theme === 'dark';
}

const listeners = new Set<() => void>();

/** Called whenever colours change; canvases read them again then. */
export function onColours(listener: () => void): () => void {
  listeners.add(listener);
  return () => listeners.delete(listener);
}

/** Writes language and colours to the page's root, now and at every change. */
export function applySettings(): void {
  const apply = () => {
    const { language } = useSettings.getState();
    document.documentElement.lang = language;
    document.documentElement.dataset.theme = isDark() ? 'dark' : 'light';
    speak(language);
    for (const listener of listeners) listener();
  };
  apply();
  useSettings.subscribe(apply);
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', apply);
}
