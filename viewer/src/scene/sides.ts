/** The sides that a scene can be looked at from, as directions away from it. */

import type { Vector3 } from './types';

/** The usual one: beside those who walk towards each other, and a little above. */
const USUAL = { x: 1, y: 0.26, z: 0.42 };

/** Around the scene; the usual one first, then those that are near it. */
export const SIDES: readonly Vector3[] = [0, 45, -45, 90, -90, 135, -135, 180].map(turned);

function turned(degrees: number): Vector3 {
  const angle = (degrees * Math.PI) / 180;
  const [sin, cos] = [Math.sin(angle), Math.cos(angle)];
  const length = Math.hypot(USUAL.x, USUAL.y, USUAL.z);
  const place = [cos * USUAL.x + sin * USUAL.z, USUAL.y, cos * USUAL.z - sin * USUAL.x];
  return place.map((value) => value / length) as Vector3;
}

/** Factor by which more must be visible from another side for it to be chosen. */
const WORTH_TURNING = 2;

/**
 * The side to look from when looking from `present`: `present`, unless much more is visible from
 * another side. `seen` has the visible amount for each side.
 */
export function betterSide(seen: readonly number[], present: Vector3 = SIDES[0]): Vector3 {
  const near = indexOfLargest(SIDES.map((side) => dot(side, present)));
  const best = indexOfLargest(seen);
  return seen[best] > WORTH_TURNING * seen[near] ? SIDES[best] : present;
}

/** The first one. */
function indexOfLargest(values: readonly number[]): number {
  return values.indexOf(values.reduce((one, other) => Math.max(one, other)));
}

function dot(a: Vector3, b: Vector3): number {
  return a.reduce((sum, value, axis) => sum + value * b[axis], 0);
}
