/**
 * The colliding bodies of a scene as a crowd. The command uses the same query, with the same work
 * and the same answer.
 */

import type { Character, Crowd, CrowdContacts, Pelt, Scene as EngineScene } from 'pelt';
import { bodiesOf, type Body } from './bodies';
import type { By } from './protocol';

export interface SceneContacts extends CrowdContacts {
  /** Like `contacts`, with numbers of bodies instead of instances, for the hash. */
  ofBodies: Uint32Array;
}

export class SceneCrowd {
  /** Palettes of the current frame, by instance. */
  readonly palettes: Float32Array[];
  readonly morphWeights: Float32Array[];
  /** Character of each instance. */
  readonly characters: Character[];
  readonly bodies: Body[];
  private readonly crowd: Crowd;
  private readonly ignored: string;

  constructor(
    pelt: Pelt,
    scene: EngineScene,
    private readonly by: By,
  ) {
    this.crowd = pelt.makeCrowd();
    this.characters = scene.instances.map(({ character }) => scene.characters[character]);
    this.palettes = this.characters.map(({ jointCount }) => new Float32Array(16 * jointCount));
    this.morphWeights = this.characters.map((c) => new Float32Array(c.morphTargetNames.length));
    this.bodies = bodiesOf(scene, by);
    for (const { instance, part } of this.bodies) this.crowd.add(this.characters[instance], part);
    this.crowd.ignore(scene.ignore);
    this.ignored = JSON.stringify(scene.ignore);
  }

  /** Whether it can be reused for that scene: the same characters, wherever they are placed. */
  fits({ instances, characters, ignore }: EngineScene, by: By): boolean {
    return (
      by === this.by &&
      instances.length === this.characters.length &&
      instances.every(({ character }, i) => characters[character] === this.characters[i]) &&
      JSON.stringify(ignore) === this.ignored
    );
  }

  set(scene: EngineScene, frame: number): void {
    this.palettes.forEach((palette, i) => scene.palette(i, frame, palette));
    this.morphWeights.forEach((weights, i) => scene.morphWeights(i, frame, weights));
    this.bodies.forEach(({ instance }, body) => {
      this.crowd.setPalette(body, this.palettes[instance]);
      this.crowd.setMorphWeights(body, this.morphWeights[instance]);
    });
  }

  collide(firstContact: boolean): SceneContacts {
    const found = this.crowd.collide({ firstContact });
    return { ...found, contacts: this.ofInstances(found.contacts), ofBodies: found.contacts };
  }

  delete(): void {
    this.crowd.delete();
  }

  private ofInstances(contacts: Uint32Array): Uint32Array {
    if (this.by === 'instance') return contacts;
    return contacts.map((value, i) => (i % 4 < 2 ? this.bodies[value].instance : value));
  }
}
