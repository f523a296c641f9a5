/**
 * Exact collision detection for skinned characters, in the browser, in Web Workers and in Node.
 *
 * Read or generate a Character, make Poses of it, and query two Poses for Contacts. The contacts are
 * those of the C++ library, bit for bit. The headers of that library define the terms.
 *
 * Arrays are typed and flat; an array of shape [N][3] stores element (i, j) at 3 * i + j. Matrices have
 * 16 floats in column-major order, as in three.js and glTF. Returned arrays belong to the caller and can
 * be transferred to another thread. Functions with an `out` parameter write to `out` instead of
 * allocating an array. `out` must have the right length.
 *
 * An engine is a loaded WebAssembly module with its own memory. Invalid arguments (an array that is too
 * short, NaN, a pose of another engine, an unknown option) throw a PeltError and change nothing. If the
 * engine runs out of memory during a call, or fails, it ends: `Pelt.hasEnded` becomes true, and every
 * later call of the engine and of its objects throws a PeltError with the code 'engine_ended'.
 * `delete()` may still be called, and returned arrays stay valid.
 *
 * Characters, poses, filters, searches, tallies, crowds and hashes live in the memory of the engine, which
 * is limited to 2 GB.
 * `delete()` frees an object at once. Otherwise it is freed when the garbage collector finalises it.
 */

import type {
  Bytes,
  Character,
  CreatureOptions,
  FaceOptions,
  Files,
  MeshArrays,
  ModelOptions,
  ReadOptions,
} from './types/character.js';
import type {
  FirstContactOptions,
  Motion,
  MovingContact,
  MovingContacts,
  MovingOptions,
  SelfMovingContacts,
} from './types/motion.js';
import type { Pose } from './types/pose.js';
import type {
  ClearanceOptions,
  CollideOptions,
  ContactGeometry,
  Contacts,
  Distance,
  DistanceOptions,
  NearPairs,
  Penetration,
  QueryStats,
} from './types/queries.js';
import type { ContactHash, Crowd, Scene, SceneParts } from './types/scene.js';
import type { CollisionSearch, SearchOptions } from './types/search.js';
import type { ContactTally, SelfContacts, SelfFilter } from './types/self.js';
export * from './types/character.js';
export * from './types/pose.js';
export * from './types/regions.js';
export * from './types/queries.js';
export * from './types/motion.js';
export * from './types/scene.js';
export * from './types/search.js';
export * from './types/self.js';

/** Loads an engine. Each Web Worker must load its own engine. */
export function loadPelt(): Promise<Pelt>;

export type ErrorCode =
  /** An argument is invalid. */
  | 'invalid_argument'
  /** A file is missing. */
  | 'unreadable_file'
  /** A file violates its format. */
  | 'malformed_file'
  /** A file is well-formed but needs a feature that Pelt does not support. */
  | 'unsupported'
  /** The engine has too little memory. `Pelt.hasEnded` says whether the engine can still be used. */
  | 'out_of_memory'
  /** The engine has failed, or was called after its end. Load a new one. */
  | 'engine_ended';

/** The message names the problem (file, array, index, value) and, if there is one, the remedy. */
export class PeltError extends Error {
  private constructor();
  readonly code: ErrorCode;
  /** The exception of a decoder or of the engine. */
  readonly cause?: unknown;
}

/** The engine. */
export interface Pelt {
  readonly version: string;

  /** True if the engine accepts no more calls. Load a new one in that case. */
  readonly hasEnded: boolean;

  /** Work of the latest query, also of one that returns no `stats`, such as `intersects`. */
  readonly lastStats: QueryStats;

  /**
   * Reads a character from the bytes of a .glb or .gltf file and prepares it for queries.
   * `options.files` contains the buffers and images of a .gltf file by their relative names.
   * Cost: some tenths of a second. Rejects files that need more than 256 MiB of memory.
   */
  readCharacter(file: Bytes, options: ReadOptions): Character;

  /** Generates a biped, 1.8 units tall, facing +z, with the clips "walk" and "idle". */
  generateCreature(options?: CreatureOptions): Character;

  /** Generates a human face with morph targets and the clip "talk". */
  generateFace(options?: FaceOptions): Character;

  /**
   * Makes a character from the arrays of a mesh, which are copied. It has no clips, and one joint, which all
   * vertices follow: a palette of one matrix places the mesh, and `Pose.setVertices` deforms it. Rejects a
   * mesh without triangles, indices out of range, and coordinates that are not finite or beyond 2^60.
   * Cost: that of `readCharacter`.
   */
  makeCharacter(mesh: MeshArrays): Character;

  /**
   * Reads a scene file (docs/scenes.md) and prepares its characters like `pelt check`. Queries of the
   * scene therefore find the same contacts and count the same work. `files` contains the file `path` and
   * all files that it refers to, with paths relative to one common folder. For example,
   * "scenes/duel.json" may refer to "../models/knight.glb", which must then be in `files` as
   * "models/knight.glb".
   */
  readScene(path: string, files: Files, options?: ModelOptions): Scene;

  /** Creates a scene from a copy of `parts`. The scene may be changed at any time. */
  makeScene(parts: SceneParts): Scene;

  /** The scene file of `pelt demo`, in which two generated characters walk into each other. */
  readonly demoScene: string;

  /**
   * Finds every pair of intersecting triangles, in ascending order. Precondition: `a` and `b` are
   * different poses.
   */
  collide(a: Pose, b: Pose, options?: CollideOptions): Contacts;

  /** Returns whether any triangles of `a` and `b` intersect. */
  intersects(a: Pose, b: Pose): boolean;

  /**
   * Finds the same contacts as `collide` without computing boxes on demand, for comparisons: skins all
   * vertices, computes the exact boxes of all nodes bottom-up, and then runs the same descent. Calls
   * `Pose.openAll` for each pose whose palette or morph weights were set since the last `openAll`, and
   * counts this as work of the query. Does not affect the nodes that other queries have opened.
   */
  collideEagerly(a: Pose, b: Pose, options?: CollideOptions): Contacts;

  /**
   * Describes where and how the triangles of the contacts intersect. Most of them intersect in a
   * segment. Chains these segments into curves, and joins connected contacts into patches.
   * Precondition: `pairs` is the result of `collide` for the current poses.
   */
  describeContacts(a: Pose, b: Pose, pairs: Uint32Array): ContactGeometry;

  /**
   * Finds every pair of triangles of one pose that intersect, apart from the corners that neighbours
   * share, and that the filter does not leave out. Pairs are in ascending order, and the first triangle
   * of a pair has the lower number. Precondition: the filter was made for the character and the part of
   * the pose. Cost: computes all vertices and boxes of the pose, unless this has been done since the last
   * palette.
   */
  selfCollide(pose: Pose, filter: SelfFilter, options?: CollideOptions): SelfContacts;

  /** Returns whether `selfCollide` would find any pair. */
  selfIntersects(pose: Pose, filter: SelfFilter): boolean;

  /**
   * Describes the contacts of a pose with itself, like `describeContacts`. Curves may end at corners that
   * two intersecting triangles share. Precondition: `pairs` is the result of `selfCollide` for the current
   * pose.
   */
  describeSelfContacts(pose: Pose, pairs: Uint32Array): ContactGeometry;

  /**
   * Returns the least distance of two posed surfaces, and two points at this distance, or null if it
   * exceeds `maxDistance`. A surface is not a solid: if one body is inside another without touching it,
   * their distance is positive.
   */
  distance(a: Pose, b: Pose, options?: DistanceOptions): Distance | null;

  /**
   * Finds every pair of triangles of `a` and `b` whose distance is at most `tolerance`, in ascending
   * order. With a tolerance of 0, these are the pairs of `collide`. Preconditions: `a` and `b` are
   * different poses, and `tolerance` is not negative.
   */
  clearance(a: Pose, b: Pose, tolerance: number, options?: ClearanceOptions): NearPairs;

  /** Returns whether `clearance` would find any pair. */
  isWithin(a: Pose, b: Pose, tolerance: number): boolean;

  /**
   * Returns the vertex of `a` inside `b` that is farthest from the surface of `b`, or null if no vertex
   * of `a` lies inside `b`. If several vertices are equally deep, returns the vertex with the lowest
   * index. The interior of a triangle of `a` may reach deeper than all vertices. The depth is not the
   * distance by which the bodies must be moved to separate them. Preconditions: `a` and `b` are different
   * poses, and the surface of `b` is closed (see `Pose.isClosed`).
   */
  deepestVertex(a: Pose, b: Pose): Penetration | null;

  /**
   * Returns which body, if any, lies wholly inside the other body without touching it:
   * - 'none': the bodies touch, or neither contains the other.
   * - 'a_in_b': no triangles touch, and every connected part of `a` lies inside `b`.
   * - 'b_in_a': no triangles touch, and every connected part of `b` lies inside `a`.
   * A body whose surface is not closed can be contained in the other body, but cannot contain the other
   * body. Precondition: `a` and `b` are different poses.
   */
  containment(a: Pose, b: Pose): 'none' | 'a_in_b' | 'b_in_a';

  /**
   * Finds every pair of triangles of `a` and `b` that intersect at any time of a step, in ascending order,
   * with the first time and what meets then. The answer is exact with respect to the posed vertices at both
   * ends, and to real numbers between them. Precondition: `a` and `b` have no pose in common.
   */
  collideMoving(a: Motion, b: Motion, options?: MovingOptions): MovingContacts;

  /** Returns whether any triangles of `a` and `b` intersect at any time of a step. */
  touchWhileMoving(a: Motion, b: Motion): boolean;

  /**
   * Returns the pair of triangles that intersects first in a step, or null if none does; of pairs with
   * exactly the same time, the lowest. It is one of the pairs of `collideMoving`, with the same time and
   * features. Precondition: that of `collideMoving`.
   */
  firstContact(a: Motion, b: Motion, options?: FirstContactOptions): MovingContact | null;

  /**
   * Finds every pair of triangles of one character that intersect at any time of a step, beyond corners that
   * they share, and that the filter does not leave out. Pairs are in ascending order, and the first triangle
   * of a pair has the lower number. Precondition: the filter was made for the character and the part of
   * the poses. Cost: computes all vertices and boxes at both ends, unless this has been done since the last
   * palettes.
   */
  selfCollideMoving(motion: Motion, filter: SelfFilter, options?: MovingOptions): SelfMovingContacts;

  /** Returns whether `selfCollideMoving` would find any pair. */
  selfTouchesWhileMoving(motion: Motion, filter: SelfFilter): boolean;

  /**
   * Starts a search for the contacts of `collide` that can be stopped after any amount of work, read, and
   * resumed. Precondition: `a` and `b` are different poses.
   */
  makeSearch(a: Pose, b: Pose, options?: SearchOptions): CollisionSearch;

  /** Creates a crowd, which queries many instances at once, like `pelt check`. */
  makeCrowd(): Crowd;

  /** Creates a hash of contacts, as printed by `pelt check`. */
  makeContactHash(): ContactHash;

  /** Creates a tally of the contacts of many poses. */
  makeContactTally(): ContactTally;
}
