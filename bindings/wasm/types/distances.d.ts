/** Options and results of distance queries. */

import type { QueryStats } from './contacts.js';

export interface ClosestPointOptions {
  /** Ignore everything farther away. Not negative. Default: Infinity. */
  maxDistance?: number;
}

export interface DistanceOptions extends ClosestPointOptions {
  /**
   * Greatest allowed difference between the result and the least distance. A positive tolerance lets
   * the query end earlier. Not negative. Default: 0.
   */
  tolerance?: number;
}

export interface ClearanceOptions {
  /** Stop at the first pair. `stats.cutShort` says whether any may be missing. */
  firstPair?: boolean;
  /** Stop after this number of pairs, at least 1. `stats.cutShort` says whether any may be missing. */
  maxPairs?: number;
}

/** Pairs of triangles whose distance is at most the tolerance of `clearance`. */
export interface NearPairs {
  readonly count: number;
  /** [N][2] Triangles of `a` and `b`, in ascending order. */
  readonly pairs: Uint32Array;
  readonly stats: QueryStats;
}

export interface SurfacePoint {
  readonly triangle: number;
  readonly position: readonly [number, number, number];
  /** Weights of the vertices of the triangle. */
  readonly weights: readonly [number, number, number];
}

export interface ClosestPoint extends SurfacePoint {
  readonly distance: number;
  readonly stats: QueryStats;
}

export interface Penetration {
  /**
   * Index of the vertex in the character of `a`. If the character has identical copies of the vertex,
   * the lowest of their indices.
   */
  readonly vertex: number;
  readonly position: readonly [number, number, number];
  /** Distance of the vertex from `closest`. */
  readonly depth: number;
  /** Closest point of the surface of `b`. */
  readonly closest: SurfacePoint;
  readonly stats: QueryStats;
}

export interface Distance {
  readonly distance: number;
  /** Proven lower bound of the least distance. Equals `distance` if the tolerance is 0. */
  readonly lowerBound: number;
  /** Two points at `distance`. */
  readonly a: SurfacePoint;
  readonly b: SurfacePoint;
  readonly stats: QueryStats;
}
