/**
 * Exact collision detection for skinned characters, in the browser, in Web Workers and in Node.
 *
 * A Character is read or generated, a Pose moves it, a query asks two Poses, Contacts come out: the
 * very ones that the C++ library finds, bit for bit. Terms are those of its headers.
 *
 * Arrays are typed and flat; a shape [N][3] has the element (i, j) at 3 * i + j. Matrices are 16
 * floats, column-major, as three.js and glTF have them. What is returned belongs to the caller (and
 * can be transferred to another thread); an `out` of the right length is written instead of a new
 * array where one is offered.
 *
 * What breaks a rule (an array too short, NaN, a pose of another engine, an option that there is not)
 * is refused by a PeltError, which leaves everything as it was. Only if the engine runs out of memory
 * in the midst of a call, or fails, is it at its end: `Pelt.hasEnded` says so, and every later call
 * of it and of its objects is refused by a PeltError with the code 'engine_ended'. `delete()` still
 * may be called, and arrays that have been returned stay good.
 *
 * Characters, poses, crowds and hashes live in the engine's memory, which has 2 GB at most. `delete()`
 * gives theirs back at once; what is forgotten is given back when JavaScript's garbage collector
 * finds it.
 */

import type {
  Bytes,
  Character,
  CreatureOptions,
  FaceOptions,
  Files,
  ModelOptions,
  ReadOptions,
} from './types/character.js';
import type { CollideOptions, ContactGeometry, Contacts } from './types/contacts.js';
import type { Distance, DistanceOptions, Penetration } from './types/distances.js';
import type { Pose } from './types/pose.js';
import type { ContactHash, Crowd, Scene, SceneParts } from './types/scene.js';
export * from './types/character.js';
export * from './types/pose.js';
export * from './types/regions.js';
export * from './types/contacts.js';
export * from './types/distances.js';
export * from './types/scene.js';

/** Loads the engine: a module with memory of its own. A Web Worker loads its own. */
export function loadPelt(): Promise<Pelt>;

export type ErrorCode =
  /** An argument breaks a stated rule. */
  | 'invalid_argument'
  /** A file is missing. */
  | 'unreadable_file'
  /** A file breaks its format. */
  | 'malformed_file'
  /** A file is well-formed but needs something that Pelt does not do. */
  | 'unsupported'
  /** The engine's memory does not suffice; see `Pelt.hasEnded` for whether it can be used on. */
  | 'out_of_memory'
  /** The engine has failed, or is called after its end: load a new one. */
  | 'engine_ended';

/** The message names the thing (file, array, index, value) and, where there is one, the remedy. */
export class PeltError extends Error {
  private constructor();
  readonly code: ErrorCode;
  /** What a decoder has thrown, or the engine. */
  readonly cause?: unknown;
}

/** The engine. */
export interface Pelt {
  readonly version: string;

  /** Whether it takes no more calls, and a new one has to be loaded. */
  readonly hasEnded: boolean;

  /**
   * A character from the bytes of a glTF file, .glb or .gltf; those of a .gltf's own files, by their
   * names beside it, in `files`. Prepared for queries, which takes some tenths of a second. A file
   * that asks for more than 256 MiB of memory is refused.
   */
  readCharacter(file: Bytes, options: ReadOptions): Character;

  /** A walking biped made by code, 1.8 units tall, facing +z, with the clips "walk" and "idle". */
  generateCreature(options?: CreatureOptions): Character;

  /** A face made by code that has morph targets, with the clip "talk". */
  generateFace(options?: FaceOptions): Character;

  /**
   * A scene as the command `pelt` reads it (docs/scenes.md), and prepared as by `pelt check`, so that
   * contacts and counters are the same. `files` has the file `path` and all that it names, by
   * paths in one folder that has them all: "scenes/duel.json" may name "../models/knight.glb", which
   * is "models/knight.glb" then.
   */
  readScene(path: string, files: Files, options?: ModelOptions): Scene;

  /** A scene of one's own: a copy of the parts, which may then be changed in it at any time. */
  makeScene(parts: SceneParts): Scene;

  /** The text of the scene of `pelt demo`: two generated characters walk into each other. */
  readonly demoScene: string;

  /** Every pair of triangles that intersect, ascending. Preconditions: two different poses. */
  collide(a: Pose, b: Pose, options?: CollideOptions): Contacts;

  /** Whether any do. */
  intersects(a: Pose, b: Pose): boolean;

  /**
   * The same contacts as an engine without refit on demand finds them: all vertices skinned, the
   * exact boxes of all nodes taken bottom-up, then the same descent. A pose that has not been refitted
   * since its palette was set is, which counts as work of this query (see `Pose.refitAll`). Poses keep
   * what queries on demand have opened.
   */
  collideEagerly(a: Pose, b: Pose, options?: CollideOptions): Contacts;

  /**
   * Where and how the contacts' triangles cut each other, chained to curves and gathered to regions.
   * `pairs` are those of `collide`, in the poses as they are now.
   */
  describeContacts(a: Pose, b: Pose, pairs: Uint32Array): ContactGeometry;

  /** The least distance of two posed surfaces; null if it is more than `maxDistance`. */
  distance(a: Pose, b: Pose, options?: DistanceOptions): Distance | null;

  /** Every pair of triangles that are at most `tolerance` apart, ascending; those of `collide` for 0. */
  clearance(a: Pose, b: Pose, tolerance: number, options?: CollideOptions): Contacts;

  /** Whether there is any. */
  isWithin(a: Pose, b: Pose, tolerance: number): boolean;

  /**
   * The vertex of `a` that is inside `b` and furthest from its surface; null: none is inside. `b` must
   * be closed (see `Pose.isClosed`).
   */
  deepestVertex(a: Pose, b: Pose): Penetration | null;

  /**
   * Whether one body holds the other whole, which no contact tells: 'none' where they touch, too. What
   * is not closed holds nothing.
   */
  containment(a: Pose, b: Pose): 'none' | 'a_in_b' | 'b_in_a';

  /** Many instances at once, as `pelt check` asks them. */
  makeCrowd(): Crowd;

  /** The hash that `pelt check` prints. */
  makeContactHash(): ContactHash;
}
