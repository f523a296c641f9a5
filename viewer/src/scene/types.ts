/** A scene, as docs/scenes.md has it: what the command reads, the page shows. */

import type { Instance, NamePair, SelfChoices } from 'pelt';

export type { Instance, SelfChoices };

export type Vector3 = [number, number, number];
export type Quaternion = [number, number, number, number];

/** How the joints of a vertex are blended. */
export type Skinning = 'linear' | 'dual-quaternion';

/** A model of a scene file: the path of a file, or options to generate it. */
export type ModelSource =
  | string
  | { file: string; skinning?: Skinning }
  | { creature: { triangles: number; joints: number; seed: number }; skinning?: Skinning };

export interface Scene {
  name: string;
  frameCount: number;
  fps: number;
  /** `character` of an instance is an index into `State.characters`. */
  instances: Instance[];
  /** Names of parts or joints whose contacts with each other do not count. */
  ignore: NamePair[];
}
