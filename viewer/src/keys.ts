/** Keyboard shortcuts. The help shows the same table. */

import * as changes from './state/changes';
import * as edits from './state/edits';
import { redo, undo } from './state/history';
import type { Change, State, Update } from './state/state';

export interface Key {
  /** Values of `KeyboardEvent.key`, in lower case, after "ctrl+" or "ctrl+shift+". */
  keys: string[];
  shown: string;
  meaning: string;
  change: (state: State, key: string) => Partial<State>;
}

/** Radians by which a key turns the camera. */
const TURN = Math.PI / 18;
const TURNS: Record<string, { right: number; up: number }> = {
  w: { right: 0, up: TURN },
  a: { right: -TURN, up: 0 },
  s: { right: 0, up: -TURN },
  d: { right: TURN, up: 0 },
};

const ZOOM = 1.15;

function ofSelected(change: (instance: number) => Change): Change {
  return (state) => (state.selected === null ? {} : change(state.selected)(state));
}

export const KEYS: Key[] = [
  { keys: [' '], shown: 'Space', meaning: 'play or pause', change: changes.togglePlaying },
  { keys: ['arrowright'], shown: '→', meaning: 'next frame', change: changes.step(1) },
  { keys: ['arrowleft'], shown: '←', meaning: 'previous frame', change: changes.step(-1) },
  { keys: ['n'], shown: 'N', meaning: 'next contact', change: changes.jumpToContact(1) },
  { keys: ['p'], shown: 'P', meaning: 'previous contact', change: changes.jumpToContact(-1) },
  { keys: ['home'], shown: 'Home', meaning: 'first frame', change: changes.toFrame(0) },
  { keys: ['end'], shown: 'End', meaning: 'last frame', change: changes.toFrame(-1) },
  {
    keys: ['0', '1', '2', '3', '4', '5', '6', '7', '8', '9'],
    shown: '0 – 9',
    meaning: 'select a character',
    change: ({ scene }, key) =>
      Number(key) < (scene?.instances.length ?? 0) ? { selected: Number(key) } : {},
  },
  {
    keys: ['escape'],
    shown: 'Esc',
    meaning: 'deselect',
    change: () => ({ selected: null, spot: null }),
  },
  {
    keys: ['delete'],
    shown: 'Del',
    meaning: 'remove the character',
    change: ofSelected(edits.removeInstance),
  },
  {
    keys: ['h'],
    shown: 'H',
    meaning: 'hide or show the character',
    change: ofSelected(changes.toggleHidden),
  },
  { keys: ['ctrl+z'], shown: 'Ctrl Z', meaning: 'undo', change: undo },
  { keys: ['ctrl+y', 'ctrl+shift+z'], shown: 'Ctrl Y', meaning: 'redo', change: redo },
  { keys: ['g'], shown: 'G', meaning: 'move the character', change: () => ({ gizmo: 'move' }) },
  { keys: ['r'], shown: 'R', meaning: 'turn the character', change: () => ({ gizmo: 'turn' }) },
  {
    keys: ['e'],
    shown: 'E',
    meaning: 'contacts between frames on or off',
    change: changes.toggleBetween,
  },
  { keys: ['f'], shown: 'F', meaning: 'limit contacts of each pair', change: changes.toggleLimit },
  { keys: ['x'], shown: 'X', meaning: 'self-contacts on or off', change: changes.toggleSelf },
  { keys: ['b'], shown: 'B', meaning: 'draw bounds', change: changes.toggleBoxes },
  { keys: ['['], shown: '[', meaning: 'coarser bounds', change: changes.changeBoxLevel(-1) },
  { keys: [']'], shown: ']', meaning: 'finer bounds', change: changes.changeBoxLevel(1) },
  {
    keys: ['w', 'a', 's', 'd'],
    shown: 'W A S D',
    meaning: 'turn the camera',
    change: (state, key) => changes.moveCamera({ kind: 'turn', ...TURNS[key] })(state),
  },
  {
    keys: ['+', '=', '-'],
    shown: '+ −',
    meaning: 'zoom in, zoom out',
    change: (state, key) =>
      changes.moveCamera({ kind: 'zoom', factor: key === '-' ? 1 / ZOOM : ZOOM })(state),
  },
  {
    keys: ['c'],
    shown: 'C',
    meaning: 'show the whole scene',
    change: changes.moveCamera({ kind: 'whole' }),
  },
  { keys: ['t'], shown: 'T', meaning: 'dark or light theme', change: changes.toggleTheme },
  { keys: ['?'], shown: '?', meaning: 'this help', change: changes.toggleHelp },
];

/** Ignores keys that the focused field or button handles itself. */
export function watchKeys(update: Update): void {
  document.addEventListener('keydown', (event) => {
    if (event.altKey || isTaken(event)) return;
    const pressed = pressedKey(event);
    const key = KEYS.find(({ keys }) => keys.includes(pressed));
    if (!key) return;
    event.preventDefault();
    update((state) => key.change(state, pressed));
  });
}

/** On a Mac, the command key takes the place of the control key. */
function pressedKey({ key, ctrlKey, metaKey, shiftKey }: KeyboardEvent): string {
  if (!ctrlKey && !metaKey) return key.toLowerCase();
  return `ctrl+${shiftKey ? 'shift+' : ''}${key.toLowerCase()}`;
}

function isTaken({ target, key, ctrlKey, metaKey }: KeyboardEvent): boolean {
  if (!(target instanceof HTMLElement)) return false;
  if (target.closest('dialog')) return key !== '?';
  if (target.matches('[type=search]')) return key !== 'Escape';
  if (ctrlKey || metaKey) return false; // a number that is typed is an edit of the scene
  if (key === 'Escape') return false;
  if (target.matches('button, summary, [type=checkbox]')) return key === ' ';
  if (target.matches('[type=range]')) return /^(Arrow|Home|End)/.test(key);
  return target.matches('input, select');
}
