/** Characters: options for reading and generating them, and their properties. */

import type { Box, Pose } from './pose.js';
import type { SelfFilter, SelfFilterOptions } from './self.js';

export type Bytes = ArrayBuffer | ArrayBufferView;

/** Files by their paths relative to a common folder. Paths must stay within that folder. */
export type Files = ReadonlyMap<string, Bytes> | Readonly<Record<string, Bytes>>;

/**
 * `MeshoptDecoder.decodeGltfBuffer` of the npm package meshoptimizer; wait for `MeshoptDecoder.ready`
 * first. An exception of the decoder becomes the `cause` of a PeltError. The decoder must not call the
 * engine.
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
  /** Decoder for EXT_meshopt_compression. Without it, compressed files are rejected. */
  meshoptDecode?: MeshoptDecode;
  /** Accept weights that do not sum to 1, and divide them by their sum, as renderers do. */
  renormalise?: boolean;
  /**
   * Whether vertices that are equal in every bit are merged, which makes queries faster. Files repeat such
   * vertices at seams of textures. Use false if `Pose.setVertices` will move them apart. Default true.
   */
  weld?: boolean;
  /**
   * How the joints of a vertex are blended. Model files do not say it. Default: as the scene file
   * says, or 'linear'. Dual quaternions move every vertex rigidly, so that twisted limbs do not
   * collapse; joints must have no scale.
   */
  skinning?: 'linear' | 'dual-quaternion';
  /** Leave out meshes without a skin (weapons, armour). */
  noUnskinned?: boolean;
  /**
   * Leave out the meshes of nodes with these names, and of all nodes below them. In a scene, a name
   * applies to all models, and "knight/Cape" to one.
   */
  exclude?: readonly string[];
  /** Number of sample poses that the tree is optimised for. Does not change answers. Default 6. */
  samples?: number;
}

export interface ReadOptions extends ModelOptions {
  /** Name of the character in messages. */
  name: string;
  files?: Files;
  /** Clips that sample poses are taken from. Default: the first clips. */
  clips?: readonly string[];
  /**
   * Largest offset along each axis, 0 to 2^60 units of the frame of the palette: one number for all
   * vertices, or [V]. Needed for `Pose.setOffsets`. Queries are faster with small caps. Vertices with caps
   * above 0 are not merged. Default: no offsets.
   */
  offsetCaps?: number | Float32Array;
}

export interface CreatureOptions {
  name?: string; // "creature"
  clips?: readonly string[]; // as in ReadOptions
  samples?: number; // as in ReadOptions
  skinning?: 'linear' | 'dual-quaternion'; // as in ModelOptions
  weld?: boolean; // as in ModelOptions
  offsetCaps?: number | Float32Array; // as in ReadOptions
  triangles?: number; // 1,000 to 1,000,000; default 13,590
  joints?: number; // 20 to 64; default 56
  seed?: number; // proportions; default 1
}

export interface FaceOptions {
  name?: string; // "face"
  clips?: readonly string[]; // as in ReadOptions
  samples?: number; // as in ReadOptions
  skinning?: 'linear' | 'dual-quaternion'; // as in ModelOptions
  weld?: boolean; // as in ModelOptions
  offsetCaps?: number | Float32Array; // as in ReadOptions
  triangles?: number; // 1,000 to 200,000; default 4,000
  seed?: number; // default 1
}

/**
 * A mesh as arrays, for `Pelt.makeCharacter`. With three.js, `restPositions` is the array of the attribute
 * `position` of a BufferGeometry, and `triangles` that of its index.
 */
export interface MeshArrays {
  /** Name of the character in messages. Default "mesh". */
  name?: string;
  /** [V][3] Positions before the palette places them. */
  restPositions: Float32Array;
  /** [T][3] Vertex indices. */
  triangles: Uint32Array | Uint16Array;
  /** As in ModelOptions, but by default false. */
  weld?: boolean;
  /** As in ReadOptions. */
  offsetCaps?: number | Float32Array;
}

/** A range of triangles that came from one primitive of the file. */
export interface Part {
  /** Name of its node, or "node:material" if several parts share the node, as in `pelt check`. */
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
  /** The name given in the options, or the name of the model in a scene file. */
  readonly name: string;
  readonly vertexCount: number;
  readonly triangleCount: number;
  readonly jointCount: number;
  /** Number of nodes of the tree over the triangles. */
  readonly nodeCount: number;
  /** Number of levels of the tree. `Pose.nodeBoxes` accepts 0 to levelCount - 1. */
  readonly levelCount: number;
  readonly parts: readonly Part[];
  readonly clips: readonly Clip[];
  /** [J] Names of the joints; "joint 7" for a joint without a name. */
  readonly jointNames: readonly string[];
  /** [M] Names of the morph targets. */
  readonly morphTargetNames: readonly string[];
  /** Contents of the file that Pelt ignored. */
  readonly warnings: readonly string[];
  /** [T][3] Vertex indices. Copied from the engine at the first use. */
  readonly triangles: Uint32Array;
  /** [V][3] Positions before skinning. Copied from the engine at the first use. */
  readonly restPositions: Float32Array;
  /** [T] Index of the part in `parts`. Copied from the engine at the first use. */
  readonly triangleParts: Uint16Array;
  /**
   * [T] Index in `jointNames` of the joint with the largest sum of weights over the triangle's vertices.
   * Copied from the engine at the first use.
   */
  readonly triangleJoints: Uint16Array;
  /** Box of the default pose. */
  readonly extent: Box;

  /**
   * Returns the joint palette of a clip: [J] matrices. If `clip` is null, returns the palette of the
   * default pose. `seconds` is clamped to the range of the clip. `placement` is the world matrix of the
   * instance, and multiplies from the left.
   */
  palette(
    clip: string | null,
    seconds: number,
    placement?: ArrayLike<number>,
    out?: Float32Array,
  ): Float32Array;

  /** Returns [M] weights of the morph targets. The parameters are those of `palette`. */
  morphWeights(clip: string | null, seconds: number, out?: Float32Array): Float32Array;

  /**
   * Creates a pose, initially with the rest positions. Poses may outlive `delete` of their character.
   * If `part` is an index into `parts`, only that part collides; the part is prepared at its first use.
   * Everything else, including triangle numbers, refers to the whole character. Rejects a part without
   * triangles.
   */
  makePose(part?: number | null): Pose;

  /**
   * Prepares `Pelt.selfCollide` for poses of this character, or of one part. Copies the arrays of the
   * options. Triangle numbers refer to the whole character; the arrays `takesPart` and `groups` have one
   * element for each triangle of the part, if one is given. Filters may outlive `delete` of their
   * character.
   */
  makeSelfFilter(options?: SelfFilterOptions, part?: number | null): SelfFilter;

  delete(): void;
}
