/** The instances of a scene as a crowd, which is what the command asks: the same work, the same
 * answer. */

import type { Character, Crowd, CrowdContacts, Pelt, Scene as EngineScene } from 'pelt';

export class SceneCrowd {
  /** Of the frame that was set last; by instances. */
  readonly palettes: Float32Array[] = [];
  readonly morphWeights: Float32Array[] = [];
  /** That of each instance. */
  readonly characters: Character[];
  private readonly crowd: Crowd;

  constructor(pelt: Pelt, { instances, characters }: EngineScene) {
    this.crowd = pelt.makeCrowd();
    this.characters = instances.map(({ character }) => characters[character]);
    for (const character of this.characters) this.add(character);
  }

  /** Whether it can take frames of that scene, too: the same characters, wherever they stand. */
  fits({ instances, characters }: EngineScene): boolean {
    return (
      instances.length === this.characters.length &&
      instances.every(({ character }, i) => characters[character] === this.characters[i])
    );
  }

  set(scene: EngineScene, frame: number): void {
    this.palettes.forEach((palette, i) => {
      this.crowd.setPalette(i, scene.palette(i, frame, palette));
      this.crowd.setMorphWeights(i, scene.morphWeights(i, frame, this.morphWeights[i]));
    });
  }

  collide(firstContact: boolean): CrowdContacts {
    return this.crowd.collide({ firstContact });
  }

  delete(): void {
    this.crowd.delete();
  }

  private add(character: Character): void {
    this.crowd.add(character);
    this.palettes.push(new Float32Array(16 * character.jointCount));
    this.morphWeights.push(new Float32Array(character.morphTargetNames.length));
  }
}
