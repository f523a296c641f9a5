/** The closest points of bodies that are within a clearance, as `pelt distance` reports them. */

import type { Pelt } from 'pelt';
import type { ClosestPoints } from './protocol';
import type { SceneContacts } from './scene_crowd';
import type { Stage } from './stage';
import { surfaceOf } from './surfaces';

/** Largest number of pairs of bodies, because each pair costs a query. */
const MOST_PAIRS = 100;

/** Returns those of each pair of bodies with contacts, the closest first. */
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
