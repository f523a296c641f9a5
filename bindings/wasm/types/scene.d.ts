/** Scenes, crowds, and the hash of their contacts. */

import type { Character } from './character.js';
import type { CollideOptions, QueryStats } from './contacts.js';
import type { Pose } from './pose.js';

/**
 * Where a character stands in a scene and what it plays, as in a scene file. Plain data, which is
 * checked whenever it is used: other keys are refused, and numbers beyond 1e12.
 */
export interface Instance {
  /** Index into `Scene.characters`. */
  character: number;
  /** null: the default pose. */
  clip: string | null;
  /** Clip time = (start + speed * time) modulo the clip's length. */
  start: number; // 0
  speed: number; // 1
  translation: [number, number, number]; // 0 0 0
  rotation: [number, number, number, number]; // quaternion x y z w, any length but 0; 0 0 0 1
  scale: number; // 1e-6 to 1e6; 1
  velocity: [number, number, number]; // units per second; 0 0 0
  /** Weights that morph targets keep, whatever the clip plays: by name, or number of the target. */
  morphWeights: Record<string, number>; // none
}

export interface SceneParts {
  name?: string;
  characters: Character[];
  /** What is left out has the default that stands beside it. */
  instances: (Pick<Instance, 'character'> & Partial<Instance>)[];
  frameCount?: number; // at least 1; 1
  fps?: number; // 1e-6 to 1e6; 30
  ignore?: NamePair[]; // none
}

/**
 * Names of parts or joints whose contacts with each other do not count, as in a scene file
 * (docs/scenes.md): `*` stands for any characters, "knight/Cape" is a name of one character alone.
 */
export type NamePair = readonly [string, string];

/** Characters, where they stand and what they play. */
export interface Scene {
  readonly name: string;
  characters: Character[];
  /** May be changed, added to and removed from at any time. */
  instances: Instance[];
  frameCount: number;
  fps: number;
  /** For `Crowd.ignore`: a scene itself asks nothing. */
  ignore: NamePair[];

  /** [J] matrices of an instance at a frame, bit for bit those of `pelt check`. */
  palette(instance: number, frame: number, out?: Float32Array): Float32Array;
  morphWeights(instance: number, frame: number, out?: Float32Array): Float32Array;

  /** Gives a pose, of the instance's character, its palette and morph weights. */
  setPose(pose: Pose, instance: number, frame: number): void;

  /** Deletes its characters. */
  delete(): void;
}

/** Instances that are asked for all their contacts at once. */
export interface Crowd {
  /** Adds an instance and returns its number. With a part only that collides, as in `makePose`. */
  add(character: Character, part?: number | null): number;
  setPalette(instance: number, palette: Float32Array): void;
  setMorphWeights(instance: number, weights: Float32Array): void;
  /**
   * From now on `collide` leaves out contacts of what these names mean, and none else; what is added
   * later, too. A name that nothing has means nothing (`readScene` refuses it). Where anything is
   * ignored, `collide` takes no limit: the contacts found first may be those to ignore.
   */
  ignore(pairs: readonly NamePair[]): void;
  /** All pairs of triangles of any two instances that intersect; `maxContacts` is of each two. */
  collide(options?: CollideOptions): CrowdContacts;
  delete(): void;
}

export interface CrowdContacts {
  readonly count: number;
  /** [N][4] instances a < b and triangles of a and b, ascending. */
  readonly contacts: Uint32Array;
  /** How many more there are that do not count. */
  readonly ignored: number;
  readonly stats: QueryStats;
}

/** FNV-1a 64 of all contacts of a run: the same for the same answer, as `pelt check` prints it. */
export interface ContactHash {
  /** Contacts of the instances a < b in a frame; frames, a and b ascending. */
  add(frame: number, a: number, b: number, pairs: Uint32Array): void;
  /** All contacts of a crowd in a frame. */
  addCrowd(frame: number, contacts: Uint32Array): void;
  /** 16 hexadecimal digits. */
  readonly value: string;
  delete(): void;
}
