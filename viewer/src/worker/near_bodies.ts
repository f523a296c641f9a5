/**
 * Finds the triangles of every two bodies of a scene that are within a distance, like
 * `pelt check --clearance`.
 */

import type { CrowdContacts, Pelt, Pose, QueryStats } from 'pelt';
import { pairsWithin } from './colliding_pairs';
import { sumOfStats } from './sums';

/** Returns contacts as a crowd has them, with numbers of bodies. */
export function findNear(
  pelt: Pelt,
  poses: readonly Pose[],
  distance: number,
  maxPairs: number,
): Pick<CrowdContacts, 'contacts' | 'stats'> {
  const contacts: number[] = [];
  const stats: QueryStats[] = [];
  for (const [a, b] of pairsWithin(poses, distance)) {
    const found = pelt.clearance(poses[a], poses[b], distance, { maxPairs });
    for (let i = 0; i < found.pairs.length; i += 2) {
      contacts.push(a, b, found.pairs[i], found.pairs[i + 1]);
    }
    stats.push(found.stats);
  }
  return { contacts: Uint32Array.from(contacts), stats: sumOfStats(stats) };
}
