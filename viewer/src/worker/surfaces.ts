/** Where on which character something is: a part, and the joint that a triangle follows most. */

import type { Character, Pose } from 'pelt';
import type { Surface } from './protocol';

export function surfaceOf(character: Character, instance: number, triangle: number): Surface {
  return {
    instance,
    part: character.parts[character.triangleParts[triangle]].name,
    joint: character.jointNames[character.triangleJoints[triangle]],
  };
}

/** What a ray meets first. */
export function firstSurface(
  poses: readonly Pose[],
  origin: readonly number[],
  direction: readonly number[],
): Surface | null {
  let nearest = Infinity;
  let surface: Surface | null = null;
  poses.forEach((pose, instance) => {
    const hit = pose.cast(origin, direction);
    if (!hit || hit.t >= nearest) return;
    nearest = hit.t;
    surface = surfaceOf(pose.character, instance, hit.triangle);
  });
  return surface;
}
