/** Dark or light, as the system or the user wants it. */

import type { State } from './state/state';

const system = matchMedia('(prefers-color-scheme: dark)');

export function isDark(theme: State['theme']): boolean {
  return theme === 'system' ? system.matches : theme === 'dark';
}

export function onSystemTheme(listener: () => void): void {
  system.addEventListener('change', listener);
}
