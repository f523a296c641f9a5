/** Contacts of a pose with itself, and their filters. */

import type { Character } from './character.js';
import type { Contacts } from './queries.js';

/** Which intersecting pairs of triangles to leave out. By default, none. */
export interface SelfFilterOptions {
  /**
   * Leaves out neighbours: 1 for triangles that share a vertex, k for triangles that are connected by a
   * chain of at most k - 1 others. 0 to 64; default 0.
   */
  rings?: number;
  /** [T] Leaves out pairs of which one triangle has the value 0, such as hidden triangles. */
  takesPart?: Uint8Array;
  /**
   * [N][2] Leaves out these pairs: those that `selfCollide` finds in a reference pose. In a filter of a
   * part, pairs with triangles of other parts matter only for `nearJoints`.
   */
  atRest?: Uint32Array;
  /** [N][2] Leaves out these pairs: those that intersect in nearly all poses. */
  always?: Uint32Array;
  /**
   * Leaves out triangles that follow the same joint or neighbouring joints most. Joints that no
   * clip moves against each other count as one. Neighbours are:
   * - a joint and any joint above it, if triangles of both share a corner. Their triangles are left
   *   out only near the joint: if, in the default pose, both triangles have a corner within 2.5
   *   radii of the centre of the corners that the lower joint shares with joints above it;
   * - a joint and the next joint above it that any triangle follows, if no triangles of both share a
   *   corner;
   * - two joints whose triangles are a pair of `atRest`. To find `atRest` without creases, use a
   *   filter with `nearJoints`.
   */
  nearJoints?: boolean;
  /** [N][2] Leaves out triangles that follow these joints most: indices into `jointNames`. */
  jointPairs?: Uint16Array;
  /** [T] Groups of triangles, for `groupPairs`: any numbers of the caller. */
  groups?: Uint16Array;
  /** [N][2] Leaves out triangles of these pairs of groups. */
  groupPairs?: Uint16Array;
}

/** A filter for `Pelt.selfCollide`. */
export interface SelfFilter {
  readonly character: Character;
  /** Index of the part that the filter was made for, or null for the whole character. */
  readonly part: number | null;
  delete(): void;
}

/**
 * How many intersecting pairs each filter has left out. A pair counts only for the first filter in this
 * order.
 */
export interface LeftOut {
  readonly takesPart: number;
  readonly rings: number;
  readonly atRest: number;
  readonly always: number;
  /** By `nearJoints` and `jointPairs`. */
  readonly joints: number;
  readonly groups: number;
}

/** In `pairs`, the first triangle of each pair has the lower number. */
export interface SelfContacts extends Contacts {
  readonly leftOut: LeftOut;
}

/** Counts in how many poses pairs of triangles intersect, for `SelfFilterOptions.always`. */
export interface ContactTally {
  /** Adds the contacts of one pose, as `selfCollide` returns them. */
  add(pairs: Uint32Array): void;
  readonly poseCount: number;
  /** [N][2] The pairs that intersected in at least this share (0 to 1) of the poses, ascending. */
  inShareOfPoses(share: number): Uint32Array;
  delete(): void;
}
