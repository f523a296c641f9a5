/**
 * Facts about contacts beside their triangles: the sides from which they are visible, those
 * between two places, and the closest points of bodies within a clearance.
 */

import type { Character, Pelt, Pose } from 'pelt';
import { SIDES } from '../scene/sides';
import type { Vector3 } from '../scene/types';
import type { ClosestPoints, Glow, Spot, Surface } from './protocol';
import type { SceneContacts } from './scene_crowd';
import type { Stage } from './stage';
import { surfaceOf } from './surfaces';

/** More would take longer and hardly say more. */
const RAYS = 48;

/** Number of sampled contacts visible from each of `SIDES`: those with a ray that nothing blocks. */
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

/** Selects the contacts of the spot from those of a crowd. */
export function contactsInSpot(
  characters: readonly Character[],
  contacts: Uint32Array,
  { a, b }: Spot,
): Uint32Array {
  const found: number[] = [];
  for (let i = 0; i < contacts.length; i += 4) {
    if (contacts[i] !== a.instance || contacts[i + 1] !== b.instance) continue;
    const [first, second] = [contacts[i + 2], contacts[i + 3]];
    const areIn = (x: number, y: number) => isIn(characters, a, x) && isIn(characters, b, y);
    if (areIn(first, second)) found.push(a.instance, b.instance, first, second);
    // Contacts of an instance with itself have no sides.
    else if (a.instance === b.instance && areIn(second, first)) {
      found.push(a.instance, b.instance, second, first);
    }
  }
  return Uint32Array.from(found);
}

function isIn(characters: readonly Character[], place: Surface, triangle: number): boolean {
  const { part, joint } = surfaceOf(characters[place.instance], place.instance, triangle);
  return part === place.part && joint === place.joint;
}

/** Largest number of pairs of bodies, because each pair costs a query. */
const MOST_PAIRS = 100;

/** Returns those of each pair of bodies with contacts, as `pelt distance` reports them, the closest first. */
export function closestPointsOf(
  pelt: Pelt,
  { characters, colliding }: Stage,
  { contacts, ofBodies }: SceneContacts,
  clearance: number,
): ClosestPoints[] {
  const found: ClosestPoints[] = [];
  let last = '';
  for (let i = 0; i < ofBodies.length && found.length < MOST_PAIRS; i += 4) {
    const [a, b] = [ofBodies[i], ofBodies[i + 1]];
    if (`${a} ${b}` === last) continue; // contacts of one pair follow each other
    last = `${a} ${b}`;
    const closest = pelt.distance(colliding[a], colliding[b], { maxDistance: clearance });
    if (!closest) continue;
    const [one, other] = [contacts[i], contacts[i + 1]];
    found.push({
      a: surfaceOf(characters[one], one, closest.a.triangle),
      b: surfaceOf(characters[other], other, closest.b.triangle),
      distance: closest.distance,
      points: [...closest.a.position, ...closest.b.position],
    });
  }
  return found.sort((one, other) => one.distance - other.distance);
}
