/** What a query of distances is asked and what it finds. */

import type { QueryStats } from './contacts.js';

export interface ClosestPointOptions {
  /** Nothing further away is looked for. Not negative; default: Infinity. */
  maxDistance?: number;
}

export interface DistanceOptions extends ClosestPointOptions {
  /** What is found may be so much further than the nearest, and is found earlier. Default: 0. */
  tolerance?: number;
}

export interface SurfacePoint {
  readonly triangle: number;
  readonly position: readonly [number, number, number];
  /** Of the triangle's corners. */
  readonly weights: readonly [number, number, number];
}

export interface ClosestPoint extends SurfacePoint {
  readonly distance: number;
  readonly stats: QueryStats;
}

export interface Penetration {
  /** Of the first body. */
  readonly vertex: number;
  readonly position: readonly [number, number, number];
  /** How far it is from the second body's surface. */
  readonly depth: number;
  /** The place of that surface. */
  readonly nearest: SurfacePoint;
  readonly stats: QueryStats;
}

export interface Distance {
  readonly distance: number;
  /** It is proven to be no less: `distance` itself, where no tolerance was allowed. */
  readonly lowerBound: number;
  readonly a: SurfacePoint;
  readonly b: SurfacePoint;
  readonly stats: QueryStats;
}
