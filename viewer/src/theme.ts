/** Dark or light, as the system or the user wants it; and whether to move by itself. */

import type { State } from './state/state';

const system = matchMedia('(prefers-color-scheme: dark)');

export function isDark(theme: State['theme']): boolean {
  return theme === 'system' ? system.matches : theme === 'dark';
}

type Theme = State['theme'];
const KEY = 'pelt-theme';

/** Theme chosen in an earlier visit. Browsers may store nothing for pages from disk. */
export function keptTheme(): Theme {
  try {
    const kept = localStorage.getItem(KEY);
    return kept === 'dark' || kept === 'light' ? kept : 'system';
  } catch {
    return 'system';
  }
}

export function keepTheme(theme: Theme): void {
  try {
    if (theme !== 'system') localStorage.setItem(KEY, theme);
  } catch {
    // Without storage, the next visit starts with the system's theme.
  }
}

export function onSystemTheme(listener: () => void): void {
  system.addEventListener('change', listener);
}

/** The system is set to show as little movement as possible. */
export function wantsStillness(): boolean {
  return matchMedia('(prefers-reduced-motion: reduce)').matches;
}
