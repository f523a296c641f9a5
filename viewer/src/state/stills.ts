/** When stills are visible, and of which frames. */

import type { Counts } from './counts';
import type { State } from './state';

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
