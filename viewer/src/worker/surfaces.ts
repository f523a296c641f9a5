/** A place on a character: a part, and the joint that a triangle follows most. */

import type { Character, Pose } from 'pelt';
import type { Questions, Surface } from './protocol';

export function surfaceOf(character: Character, instance: number, triangle: number): Surface {
  return {
    instance,
    part: character.parts[character.triangleParts[triangle]].name,
    joint: character.jointNames[character.triangleJoints[triangle]],
  };
}

/** A number for the part and joint of each triangle: the same number, the same names. */
export interface Places {
  ofTriangle: Uint32Array;
  count: number;
}

const known = new WeakMap<Character, Places>();

export function placesOf(character: Character): Places {
  const places = known.get(character) ?? numberPlaces(character);
  known.set(character, places);
  return places;
}

function numberPlaces({ triangleParts, triangleJoints, jointCount, parts }: Character): Places {
  const ofTriangle = new Uint32Array(triangleParts.length);
  for (let t = 0; t < ofTriangle.length; ++t) {
    ofTriangle[t] = triangleParts[t] * jointCount + triangleJoints[t];
  }
  return { ofTriangle, count: parts.length * jointCount };
}

/** First hit of a ray. */
export function firstSurface(
  poses: readonly Pose[],
  { origin, direction, hidden }: Questions['cast'],
): Surface | null {
  let nearest = Infinity;
  let surface: Surface | null = null;
  poses.forEach((pose, instance) => {
    const hit = hidden.includes(instance) ? null : pose.cast(origin, direction);
    if (!hit || hit.t >= nearest) return;
    nearest = hit.t;
    surface = surfaceOf(pose.character, instance, hit.triangle);
  });
  return surface;
}
