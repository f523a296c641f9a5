/** A search for contacts that can be stopped, read and resumed. */

import type { QueryStats } from './queries.js';

export interface SearchOptions {
  /**
   * What the search does first:
   * - 'firstContact': depth first, deepest overlap first, like `intersects`: a verdict soon. The default.
   * - 'resolution': longest region first: shrinks all regions evenly.
   * - 'contacts': deepest overlap first, relative to its length: many contacts soon.
   */
  order?: 'firstContact' | 'resolution' | 'contacts';
  /**
   * Limit of the number of open regions, 1 to 2^20. Beyond the limit, the search finishes the region that
   * it has begun before it begins another one. Default: 4096.
   */
  maxOpen?: number;
}

/** Parts of the surfaces whose triangles have not been compared yet. */
export interface OpenRegions {
  readonly count: number;
  /** [N][6] Low and high corner of a box that contains every contact of these triangles. */
  readonly boxes: Float32Array;
  /** [N] Least translation along an axis that parts the boxes of the two nodes. */
  readonly depths: Float32Array;
  /** [N] Number of pairs of these triangles. */
  readonly pairCounts: Float64Array;
}

/**
 * A `collide` that can be stopped after any amount of work, read, and resumed.
 *
 *     const search = pelt.makeSearch(a, b, { order: 'contacts' });
 *     while (!search.isComplete && frameHasTime()) search.run(2000);
 *     show(search.pairs());
 *
 * After any amount of work, `pairs` are contacts of `collide`, and each missing contact is a pair of
 * triangles of an open region and touches in its box. More work adds contacts, removes none, and shrinks
 * the union of the regions. When nothing is open, `pairs` is the answer of `collide`, bit for bit.
 *
 * Work is counted in fixed units, so the state of a search is the same on every machine. No clock is read.
 * The poses must not be deleted before the search; otherwise all calls but `delete` throw.
 */
export interface CollisionSearch {
  /**
   * Searches until `budget` units of work are done, or nothing is open. With the order 'firstContact',
   * also stops when the first contact is found. Returns the work of this call; `cutShort` says whether
   * regions are left open. Work beyond the budget is subtracted from the next call. `budget` is a whole
   * number, or Infinity. Throws if the search is stale.
   */
  run(budget: number): QueryStats;
  /** Starts anew with the current palettes and morph weights of the same poses. */
  restart(): void;

  /** Whether nothing is open. */
  readonly isComplete: boolean;
  /** Whether a palette or morph weights of a pose were set since the search was started. */
  readonly isStale: boolean;
  readonly verdict: 'apart' | 'touching' | 'unknown';
  /** Number of pairs of triangles that are not decided yet. Never rises. */
  readonly undecidedPairs: number;
  /** Longest side of any open region; 0 if nothing is open. */
  readonly resolution: number;
  /** Upper bound of the distance of the poses, which never rises; 0 if a contact is known. */
  readonly distanceBound: number;
  /** Units of work done since the search was started. */
  readonly workDone: number;
  /** Units of work of the longest step so far. `run` exceeds its budget by less. */
  readonly longestStep: number;

  /** Returns [N][2] triangles of the contacts found so far, in ascending order if the search is complete. */
  pairs(): Uint32Array;
  /** Returns all open regions, in no particular order. */
  openRegions(): OpenRegions;

  delete(): void;
}
