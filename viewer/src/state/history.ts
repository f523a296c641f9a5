/** Edits of the scene, which can be undone and redone. */

import { EDITED, type Change, type Edit, type State } from './state';

/** Number of edits that can be undone. */
const MOST = 200;

/**
 * Makes a change one that can be undone. Consecutive changes of one subject, such as the steps of
 * a drag, are a single edit, until `endEdit`.
 */
export function edit(subject: string | null, change: Change): Change {
  return (state) => {
    const changed = change(state);
    if (changed.scene === undefined || changed.scene === state.scene) return changed;
    const goesOn = subject !== null && state.past.at(-1)?.subject === subject;
    if (goesOn) return changed;
    const past = [...state.past.slice(1 - MOST), { before: editedOf(state), subject }];
    return { ...changed, past, future: [] };
  };
}

export const endEdit: Change = ({ past }) => (past.at(-1)?.subject ? { past: closed(past) } : {});

export const undo: Change = (state) => {
  const { past, future } = state;
  if (past.length === 0) return {};
  const present = { before: editedOf(state), subject: null };
  return {
    ...goTo(state, past.at(-1)!),
    past: closed(past.slice(0, -1)),
    future: [...future, present],
  };
};

export const redo: Change = (state) => {
  const { past, future } = state;
  if (future.length === 0) return {};
  const present = { before: editedOf(state), subject: null };
  return { ...goTo(state, future.at(-1)!), past: [...past, present], future: future.slice(0, -1) };
};

function editedOf(state: State): Edit['before'] {
  return Object.fromEntries(EDITED.map((fact) => [fact, state[fact]])) as Edit['before'];
}

function closed(past: readonly Edit[]): Edit[] {
  return past.map((one) => (one.subject === null ? one : { ...one, subject: null }));
}

function goTo({ frame }: State, { before }: Edit): Partial<State> {
  return { ...before, frame: Math.min(frame, before.scene!.frameCount - 1), spot: null };
}
