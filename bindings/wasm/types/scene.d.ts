/** Scenes, crowds, and the hash of their contacts. */

import type { Character } from './character.js';
import type { CollideOptions, QueryStats } from './queries.js';
import type { MovingColumns, MovingOptions } from './motion.js';
import type { Pose } from './pose.js';
import type { LeftOut, SelfFilter } from './self.js';

/**
 * Placement and clip of a character in a scene, as in a scene file. Plain data, which is validated
 * whenever it is used: unknown keys and numbers beyond 1e12 are rejected.
 */
export interface Instance {
  /** Index into `Scene.characters`. */
  character: number;
  /** Name of the clip, or null for the default pose. */
  clip: string | null;
  /** The clip time is (start + speed * time) modulo the duration of the clip. */
  start: number; // 0
  speed: number; // 1
  translation: [number, number, number]; // 0 0 0
  rotation: [number, number, number, number]; // quaternion x y z w, any length but 0; 0 0 0 1
  scale: number; // 1e-6 to 1e6; 1
  velocity: [number, number, number]; // units per second; 0 0 0
  /** Fixed weights of morph targets, by name or number. They override the clip. */
  morphWeights: Record<string, number>; // none
}

export interface SceneParts {
  name?: string;
  characters: Character[];
  /** Omitted properties have the defaults noted in Instance. */
  instances: (Pick<Instance, 'character'> & Partial<Instance>)[];
  frameCount?: number; // at least 1; 1
  fps?: number; // 1e-6 to 1e6; 30
  ignore?: NamePair[]; // none
  self?: SelfChoices; // none
}

/**
 * Whether and how bodies are tested against themselves, as in a scene file (docs/scenes.md). Choices that
 * are undefined have the defaults of `pelt check`.
 */
export interface SelfChoices {
  /** `self` of the scene file. 'also': bodies are tested against themselves and against each other. */
  wanted?: 'off' | 'also' | 'only' | undefined;
  /** `self_rings`: 0 to 64. */
  rings?: number | undefined;
  /** `self_at_rest`. */
  dropsAtRest?: boolean | undefined;
  /** `self_always`: a share of the frames, more than 0 and at most 1; null keeps all contacts. */
  always?: number | null | undefined;
  /** `self_near_joints`. */
  dropsNearJoints?: boolean | undefined;
}

/**
 * Names of parts or joints whose contacts with each other do not count, as in a scene file
 * (docs/scenes.md). `*` matches any characters, and "knight/Cape" is a name of one character only.
 */
export type NamePair = readonly [string, string];

/** Characters with their placements and clips. */
export interface Scene {
  readonly name: string;
  characters: Character[];
  /** Instances may be changed, added and removed at any time. */
  instances: Instance[];
  frameCount: number;
  fps: number;
  /** For `Crowd.ignore`. The scene itself runs no queries. */
  ignore: NamePair[];
  /** For `Crowd.setSelfFilter`. The scene itself runs no queries. */
  self: SelfChoices;

  /** Returns [J] matrices of an instance at a frame, bit for bit those of `pelt check`. */
  palette(instance: number, frame: number, out?: Float32Array): Float32Array;
  /** Returns [M] morph weights of an instance at a frame. */
  morphWeights(instance: number, frame: number, out?: Float32Array): Float32Array;

  /** Sets palette and morph weights of a pose of the instance's character. */
  setPose(pose: Pose, instance: number, frame: number): void;

  /** Deletes the characters of the scene. */
  delete(): void;
}

/** Many instances that are queried at once. */
export interface Crowd {
  /** Adds an instance and returns its number. If `part` is given, only that part collides. */
  add(character: Character, part?: number | null): number;
  /** Like `Pose.setPalette`. */
  setPalette(instance: number, palette: Float32Array | Float64Array): void;
  /** Like `Pose.setDualQuaternions`. */
  setDualQuaternions(instance: number, dualQuaternions: Float32Array): void;
  /** Like `Pose.setMorphWeights`. */
  setMorphWeights(instance: number, weights: Float32Array): void;
  /** Like `Pose.setVertices`. */
  setVertices(instance: number, vertices: Float32Array): void;
  /** Like `Pose.setOffsets`. */
  setOffsets(instance: number, offsets: Float32Array | null): void;
  /**
   * With a filter, `collide` and `collideMoving` also test the instance against itself. With null, they do
   * not. The filter must have been made for the character and the part of the instance, and may be deleted
   * afterwards.
   */
  setSelfFilter(instance: number, filter: SelfFilter | null): void;
  /**
   * Filters the contacts between these instances, which are parts of one character in one pose. The filter
   * must have been made for the whole character, and may be deleted afterwards. Limits count the contacts
   * that remain.
   */
  filterParts(instances: readonly number[], filter: SelfFilter): void;
  /**
   * Replaces the list of ignored pairs. `collide` then leaves out all contacts that match a pair. The
   * list also applies to instances that are added later. A name that matches nothing has no effect here,
   * but `readScene` rejects such a name. While the list is not empty, `collide` and `collideMoving` reject
   * limits of the contacts, because the contacts found first may be ignored.
   */
  ignore(pairs: readonly NamePair[]): void;
  /**
   * Finds all intersecting triangles of any two instances, and of instances with a self filter.
   * `maxContacts` applies to each pair of instances, and to each instance with itself.
   */
  collide(options?: CollideOptions): CrowdContacts;
  /**
   * Begins a step for `collideMoving`: the present poses of all instances become the start of the step. The
   * first `setPalette`, `setDualQuaternions`, `setMorphWeights`, `setVertices` or `setOffsets` of an instance
   * after this call begins its motion. Later calls change the end of the motion. An instance without such a
   * call stands still.
   */
  beginStep(): void;
  /**
   * Sets the palettes of an instance at both ends of the current step. Morph weights and offsets at both ends
   * are the present ones. `collide` uses the palette `to`. After an error, the instance stands still.
   */
  setMotion(
    instance: number,
    from: Float32Array | Float64Array,
    to: Float32Array | Float64Array,
  ): void;
  /** Like `setMotion`, with palettes of dual quaternions as for `Pose.setDualQuaternions`. */
  setMotionDualQuaternions(instance: number, from: Float32Array, to: Float32Array): void;
  /**
   * Finds all triangles of any two instances, and of instances with a self filter, that intersect at any
   * time of the current step. The answer is that of `Pelt.collideMoving` and `Pelt.selfCollideMoving`.
   * `maxContacts` applies to each pair of instances, and to each instance with itself.
   */
  collideMoving(options?: MovingOptions): CrowdMovingContacts;
  /**
   * Leaves out contacts that match an ignored pair. `contacts` are rows as in `CrowdContacts`, with the
   * instances of the crowd and the triangle numbers of whole characters, from any query, such as
   * `clearance`. The order of the rows stays.
   */
  withoutIgnored(contacts: Uint32Array): CountedContacts;
  delete(): void;
}

export interface CountedContacts {
  /** [N][4] The contacts that count. */
  readonly contacts: Uint32Array;
  /** Number of contacts that were left out. */
  readonly ignored: number;
}

export interface CrowdContacts {
  readonly count: number;
  /**
   * [N][4] Instance a, instance b, triangle of a, triangle of b. a < b, or a = b for contacts of an
   * instance with itself. Rows ascend.
   */
  readonly contacts: Uint32Array;
  /** Number of contacts that were left out. */
  readonly ignored: number;
  /** What the self filters have left out. */
  readonly leftOut: LeftOut;
  readonly stats: QueryStats;
}

/** Rows ascend. The arrays of `MovingColumns` are empty without the option `times`. */
export interface CrowdMovingContacts extends CrowdContacts, MovingColumns {}

/** FNV-1a hash with 64 bits over all contacts of a run, as printed by `pelt check`. */
export interface ContactHash {
  /**
   * Adds the contacts of the instances a < b in a frame. The value depends on the order of the calls. For
   * the value of `pelt check`, add frames in ascending order, and in each frame the pairs (a, b) in
   * ascending order.
   */
  add(frame: number, a: number, b: number, pairs: Uint32Array): void;
  /** Adds all contacts of a crowd in a frame. */
  addCrowd(frame: number, contacts: Uint32Array): void;
  /** 16 hexadecimal digits. */
  readonly value: string;
  delete(): void;
}
