/**
 * Finds the triangles of every two bodies of a scene that are within a distance, like
 * `pelt check --clearance`.
 */

import type { Character, CrowdContacts, Pelt, Pose, QueryStats } from 'pelt';
import type { Body } from './bodies';
import { pairsWithin } from './colliding_pairs';
import { sumOfStats } from './sums';

export class NearBodies {
  private readonly poses: Pose[];

  /** `characters` has that of each instance. */
  constructor(
    private readonly pelt: Pelt,
    characters: readonly Character[],
    private readonly bodies: readonly Body[],
  ) {
    this.poses = bodies.map(({ instance, part }) => characters[instance].makePose(part));
  }

  /** Palettes and weights of each instance. */
  set(palettes: readonly Float32Array[], weights: readonly Float32Array[]): void {
    this.poses.forEach((pose, body) => {
      const { instance } = this.bodies[body];
      pose.setMorphWeights(weights[instance]);
      pose.setPalette(palettes[instance]);
    });
  }

  /** Returns contacts as a crowd has them, with numbers of bodies. */
  find(distance: number, maxPairs: number): Pick<CrowdContacts, 'contacts' | 'stats'> {
    const contacts: number[] = [];
    const stats: QueryStats[] = [];
    for (const [a, b] of pairsWithin(this.poses, distance)) {
      const found = this.pelt.clearance(this.poses[a], this.poses[b], distance, { maxPairs });
      for (let i = 0; i < found.pairs.length; i += 2) {
        contacts.push(a, b, found.pairs[i], found.pairs[i + 1]);
      }
      stats.push(found.stats);
    }
    return { contacts: Uint32Array.from(contacts), stats: sumOfStats(stats) };
  }

  delete(): void {
    for (const pose of this.poses) pose.delete();
  }
}
