/** Sums over the counts of a sweep. */

import type { State } from './state';

/** Contacts of the frames so far; null for frames that are not checked. */
export type Counts = State['sweep']['counts'];

interface Totals {
  contacts: number;
  /** Numbers of frames. */
  checked: number;
  inContact: number;
}

export function totalsOf(counts: Counts): Totals {
  const known = counts.filter((count) => count !== null);
  return {
    contacts: known.reduce((sum, count) => sum + count, 0),
    checked: known.length,
    inContact: known.filter((count) => count > 0).length,
  };
}

/** Numbers of frames by what is known about them with a limit of the work. */
export function undecidedFrames({
  counts,
  undecided,
}: Pick<State['sweep'], 'counts' | 'undecided'>) {
  const frames = { unknown: 0, touching: 0, decided: 0 };
  undecided.forEach((pairs, frame) => {
    if (pairs === null) return;
    ++frames[pairs === 0 ? 'decided' : counts[frame] ? 'touching' : 'unknown'];
  });
  return frames;
}
