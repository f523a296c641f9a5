import type { Pose, Scene as EngineScene } from 'pelt';
import type { SceneCrowd } from './scene_crowd';

/** A pose for each instance of a scene: what is drawn, and what a single instance is asked. */
export class Poses {
  readonly all: Pose[];

  constructor({ instances, characters }: EngineScene) {
    this.all = instances.map(({ character }) => characters[character].makePose());
  }

  /** Takes what the crowd has been set to. Closes all nodes that queries have opened. */
  follow({ palettes, morphWeights }: SceneCrowd): void {
    this.all.forEach((pose, i) => {
      pose.setMorphWeights(morphWeights[i]);
      pose.setPalette(palettes[i]);
    });
  }

  delete(): void {
    for (const pose of this.all) pose.delete();
  }
}
