/**
 * Finds contacts of every two bodies of a scene with a limit of the work, like `pelt check --budget`.
 * Work is counted in units, so the answer is that of the command.
 */

import type { CrowdContacts, Pelt, Pose, QueryStats } from 'pelt';
import { pairsWithin } from './colliding_pairs';
import { sumOfStats } from './sums';

/** Contacts as a crowd has them, with numbers of bodies, and undecided pairs of triangles. */
export interface PartialContacts extends Pick<CrowdContacts, 'contacts' | 'stats'> {
  undecided: number;
}

export function findWithBudget(
  pelt: Pelt,
  poses: readonly Pose[],
  budget: number,
): PartialContacts {
  const contacts: number[] = [];
  const stats: QueryStats[] = [];
  let undecided = 0;
  for (const [a, b] of pairsWithin(poses, 0)) {
    const search = pelt.makeSearch(poses[a], poses[b], { order: 'resolution' });
    stats.push(search.run(budget));
    undecided += search.undecidedPairs;
    for (const [triangleA, triangleB] of ascending(search.pairs())) {
      contacts.push(a, b, triangleA, triangleB);
    }
    search.delete();
  }
  return { contacts: Uint32Array.from(contacts), stats: sumOfStats(stats), undecided };
}

/** A search that is not complete returns contacts in the order in which it has found them. */
function ascending(pairs: Uint32Array): [number, number][] {
  const rows = Array.from({ length: pairs.length / 2 }, (_, i): [number, number] => [
    pairs[2 * i],
    pairs[2 * i + 1],
  ]);
  return rows.sort(([a, b], [c, d]) => a - c || b - d);
}
