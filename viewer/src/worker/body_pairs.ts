/**
 * Queries of every two bodies of a scene that a crowd does not offer: within a distance, like
 * `pelt check --clearance`, and with a limit of the work, like `pelt check --budget`.
 */

import type { Bounds, Character, CrowdContacts, Pelt, Pose, QueryStats } from 'pelt';
import type { Body } from './bodies';
import { sumOfStats } from './sums';

/** Contacts as a crowd has them, with numbers of bodies, and undecided pairs of triangles. */
export interface PartialContacts extends Pick<CrowdContacts, 'contacts' | 'stats'> {
  undecided: number;
}

/** Work is counted in units, so the answer is that of the command. */
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

/** Returns the triangles within the distance: contacts as a crowd has them, with numbers of bodies. */
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

/** The pairs of poses whose boxes overlap. */
export function collidingPairs(poses: readonly Pose[]): [Pose, Pose][] {
  return pairsWithin(poses, 0).map(([a, b]) => [poses[a], poses[b]]);
}

/** The pairs of poses whose boxes are at most this far apart along each axis, ascending. */
export function pairsWithin(poses: readonly Pose[], distance: number): [number, number][] {
  const boxes = poses.map((pose) => pose.bounds().box);
  return boxes.flatMap((box, a) =>
    boxes
      .slice(a + 1)
      .flatMap((other, i): [number, number][] =>
        areWithin(box, other, distance) ? [[a, a + 1 + i]] : [],
      ),
  );
}

/** More than all roundings of a difference. */
const SLACK = 1 + 1e-9;

function areWithin(one: Bounds['box'], other: Bounds['box'], distance: number): boolean {
  return [0, 1, 2].every(
    (axis) =>
      one.low[axis] - other.high[axis] <= distance * SLACK &&
      other.low[axis] - one.high[axis] <= distance * SLACK,
  );
}

/** One pose per body of a scene. */
export class BodyPoses {
  readonly all: readonly Pose[];

  /** `characters` has that of each instance. */
  constructor(
    characters: readonly Character[],
    private readonly bodies: readonly Body[],
  ) {
    this.all = bodies.map(({ instance, part }) => characters[instance].makePose(part));
  }

  /** Palettes and weights of each instance. */
  set(palettes: readonly Float32Array[], weights: readonly Float32Array[]): void {
    this.all.forEach((pose, body) => {
      const { instance } = this.bodies[body];
      pose.setMorphWeights(weights[instance]);
      pose.setPalette(palettes[instance]);
    });
  }

  delete(): void {
    for (const pose of this.all) pose.delete();
  }
}
