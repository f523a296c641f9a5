/** Options and results of queries of motions. */

import type { QueryStats } from './queries.js';
import type { Pose } from './pose.js';
import type { LeftOut } from './self.js';

/**
 * A step of one character. Each vertex moves in a straight line, at constant speed, from its posed
 * position in `from` at time 0 to that in `to` at time 1. If the morph weights of both poses are equal,
 * this is the motion of linear blend skinning with linearly blended palettes, up to rounding.
 *
 * In a sequence of frames, use two poses in turn: the `to` of a step is the `from` of the next, and what
 * queries have computed for it remains valid.
 *
 * Precondition: both poses are of one character, or of one part of it. They may be one pose, which then
 * stands still.
 */
export interface Motion {
  readonly from: Pose;
  readonly to: Pose;
}

export interface FirstContactOptions {
  /** Leave out pairs that intersect at time 0. */
  leaveOutStart?: boolean;
}

export interface MovingOptions extends FirstContactOptions {
  /** Whether to compute times and features. The query is faster without them. Default: true. */
  times?: boolean;
  /** Stop after this number of contacts, at least 1. `stats.cutShort` says whether any may be missing. */
  maxContacts?: number;
}

export const FeatureKind: {
  /** Corner `number` of the triangle, 0 to 2. */
  readonly corner: 0;
  /** The edge from corner `number` to the next corner. */
  readonly edge: 1;
  /** The whole triangle. `number` is 0. */
  readonly face: 2;
};

/** A corner of a triangle, an edge with its ends, or the whole triangle. */
export interface Feature {
  /** A FeatureKind. */
  readonly kind: number;
  readonly number: number;
}

/**
 * Work of a query of motions. A test in single precision decides most pairs of triangles, and a slower
 * one in double most others. Exact arithmetic decides the rest.
 */
export interface MovingStats extends QueryStats {
  /** Pairs of triangles tested in double. */
  readonly doublePairs: number;
  /** Of these, pairs tested in exact arithmetic. */
  readonly exactPairs: number;
}

/** When triangles first intersect, and what meets then. */
export interface MovingColumns {
  /**
   * [N] The largest float that is not above the first time at which the triangles intersect, 0 to 1. The
   * triangles are apart at all earlier times. Empty without `times`, like the next arrays.
   */
  readonly times: Float32Array;
  /** [N] 1 if the triangles intersect at time 0, otherwise 0. */
  readonly atStart: Uint8Array;
  /**
   * [N][4] What meets at the first time: FeatureKind and number of the feature of `a`, then of `b`. Of all
   * features that meet, these are the first in this order: two corners, a corner and an edge, an edge
   * and a corner, a corner and a face, a face and a corner, two edges. Zeros if `atStart` is 1.
   */
  readonly features: Uint8Array;
}

export interface MovingContacts extends MovingColumns {
  readonly count: number;
  /** [N][2] Triangles of `a` and `b`, in ascending order. */
  readonly pairs: Uint32Array;
  readonly stats: MovingStats;
}

/**
 * In `pairs`, the first triangle of each pair has the lower number. Features that contain a shared corner of
 * the two triangles are left out of `features`; if no others meet, both are whole faces.
 */
export interface SelfMovingContacts extends MovingContacts {
  readonly leftOut: LeftOut;
}

/** The pair of triangles that intersects first. */
export interface MovingContact {
  readonly triangleA: number;
  readonly triangleB: number;
  /** As in `MovingContacts.times`. */
  readonly time: number;
  readonly atStart: boolean;
  /** Have no meaning if `atStart` is true. */
  readonly featureA: Feature;
  readonly featureB: Feature;
  readonly stats: MovingStats;
}
