/** Sums over the counts of a sweep, and its worst frames. */

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

/** Number of stills. */
const MOST = 3;

export function showsStills({ listing, scene }: State): boolean {
  return listing === 'clip' && scene !== null && scene.frameCount > 1;
}

/** Returns the worst frames, sorted by time, and far enough apart to differ. */
export function worstFrames(counts: Counts): number[] {
  const inContact = [...counts.keys()].filter((frame) => counts[frame]);
  const apart = inContact.length / (2 * MOST);
  const worst: number[] = [];
  for (const frame of inContact.sort((one, other) => counts[other]! - counts[one]!)) {
    if (worst.every((taken) => Math.abs(taken - frame) > apart)) worst.push(frame);
  }
  return worst.slice(0, MOST).sort((one, other) => one - other);
}

/** Returns the first frame with the most contacts; undefined without contacts. */
export function worstFrame(counts: Counts): number | undefined {
  const most = counts.reduce<number>((one, other) => Math.max(one, other ?? 0), 0);
  return most === 0 ? undefined : counts.indexOf(most);
}
