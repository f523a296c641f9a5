/** One pose per body of a scene, for queries of two bodies that a crowd does not offer. */

import type { Character, Pose } from 'pelt';
import type { Body } from './bodies';

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
