/**
 * Finds the sides from which contacts are visible, by rays from some of them that nothing blocks.
 */

import type { Pose } from 'pelt';
import { SIDES } from '../scene/sides';
import type { Vector3 } from '../scene/types';
import type { Glow } from './protocol';

/** More would take longer and hardly say more. */
const RAYS = 48;

/** Number of sampled contacts visible from each of `SIDES`. */
export function seenFromSides(poses: readonly Pose[], glow: Glow): number[] {
  const places = placesOf(glow);
  return SIDES.map((side) => places.filter((place) => isFree(poses, place, side)).length);
}

interface Place {
  centre: Vector3;
  /** Radius of the triangle, which crosses the surface that it touches. */
  radius: number;
}

function placesOf({ triangles, centres, corners }: Glow): Place[] {
  const step = Math.max(1, Math.ceil(triangles / RAYS));
  const places: Place[] = [];
  for (let t = 0; t < triangles; t += step) {
    const centre = [...centres.subarray(3 * t, 3 * t + 3)] as Vector3;
    const corner = corners.subarray(9 * t, 9 * t + 3);
    places.push({ centre, radius: Math.hypot(...centre.map((value, i) => value - corner[i])) });
  }
  return places;
}

function isFree(poses: readonly Pose[], { centre, radius }: Place, side: Vector3): boolean {
  const begin = centre.map((value, i) => value + radius * side[i]);
  return !poses.some((pose) => pose.castAny(begin, side));
}
