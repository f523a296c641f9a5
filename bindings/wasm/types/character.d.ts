/** Characters: how they are read or generated, and what they have. */

import type { Box, Pose } from './pose.js';

export type Bytes = ArrayBuffer | ArrayBufferView;

/** By their paths in one folder, which they do not leave. */
export type Files = ReadonlyMap<string, Bytes> | Readonly<Record<string, Bytes>>;

/**
 * `MeshoptDecoder.decodeGltfBuffer` of the npm package meshoptimizer, once its `ready` is. What it
 * throws is the `cause` of the PeltError that follows. It may not call the engine.
 */
export type MeshoptDecode = (
  target: Uint8Array,
  count: number,
  size: number,
  source: Uint8Array,
  mode: string,
  filter?: string,
) => void;

export interface ModelOptions {
  /** For files compressed by EXT_meshopt_compression; without it they are refused. */
  meshoptDecode?: MeshoptDecode;
  /** Accept weights that do not sum to 1: divide them by their sum, as renderers do. */
  renormalise?: boolean;
  /** Leave out meshes without a skin (weapons, armour). */
  noUnskinned?: boolean;
  /** Names of mesh nodes to leave out, with their children; in a scene of any model, or "knight/Cape". */
  exclude?: readonly string[];
  /** Poses taken from the clips to prepare for; no answer depends on it. Default 6. */
  samples?: number;
}

export interface ReadOptions extends ModelOptions {
  /** What messages and tables call it. */
  name: string;
  files?: Files;
  /** The clips to prepare for; default: the first ones. */
  clips?: readonly string[];
}

export interface CreatureOptions {
  name?: string; // "creature"
  clips?: readonly string[]; // as in ReadOptions, and the next too
  samples?: number;
  triangles?: number; // 1,000 to 1,000,000; default 13,590
  joints?: number; // 20 to 64; default 56
  seed?: number; // proportions; default 1
}

export interface FaceOptions {
  name?: string; // "face"
  clips?: readonly string[]; // as in ReadOptions, and the next too
  samples?: number;
  triangles?: number; // 1,000 to 200,000; default 4,000
  seed?: number; // default 1
}

/** A range of triangles that came from one primitive of the file. */
export interface Part {
  /** Of its node, "node:material" where several share that; as `pelt check` names it. */
  readonly name: string;
  readonly firstTriangle: number;
  readonly triangleCount: number;
  readonly skinned: boolean;
}

export interface Clip {
  readonly name: string;
  readonly seconds: number;
}

export interface Character {
  /** As it was given when it was read; names a character of a scene. */
  readonly name: string;
  readonly vertexCount: number;
  readonly triangleCount: number;
  readonly jointCount: number;
  /** Of the tree over the triangles. */
  readonly nodeCount: number;
  /** Of the tree: `Pose.nodeBoxes` takes the levels 0 to levelCount - 1. */
  readonly levelCount: number;
  readonly parts: readonly Part[];
  readonly clips: readonly Clip[];
  /** [J] "joint 7" where the file has no name. */
  readonly jointNames: readonly string[];
  /** [M] */
  readonly morphTargetNames: readonly string[];
  /** What the file has and Pelt passed over. */
  readonly warnings: readonly string[];
  /** [T][3] indices of vertices. A copy is made at the first use, as with the next three. */
  readonly triangles: Uint32Array;
  /** [V][3] before skinning. */
  readonly restPositions: Float32Array;
  /** [T] into `parts`. */
  readonly triangleParts: Uint16Array;
  /** [T] into `jointNames`: the joint that a triangle's corners follow most. */
  readonly triangleJoints: Uint16Array;
  /** Of the default pose. */
  readonly extent: Box;

  /**
   * [J] matrices at `seconds` of a clip, clamped to its range; null: the default pose. `placement`
   * stands before everything, as the instance's world matrix.
   */
  palette(
    clip: string | null,
    seconds: number,
    placement?: ArrayLike<number>,
    out?: Float32Array,
  ): Float32Array;

  /** [M] weights of the morph targets as the clip has them. */
  morphWeights(clip: string | null, seconds: number, out?: Float32Array): Float32Array;

  /**
   * In the rest positions at first. Poses may outlive their character's `delete`. With an index into
   * `parts` only that part collides, and is prepared for that at the first use; all else, numbers of
   * triangles too, is as of the whole. A part without triangles is refused.
   */
  makePose(part?: number | null): Pose;

  delete(): void;
}
