/** Simple solids and other regions of space. */

import type { QueryStats } from './queries.js';

/** Three numbers. */
export type Vector = readonly number[] | Float32Array | Float64Array;

/** A closed convex set of points. Its numbers are rounded to single precision. */
export type Region =
  HalfSpace | BoxRegion | OrientedBox | ConvexPolyhedron | Sphere | Capsule | Frustum;

/** All points p with normal . p <= offset, behind a plane whose normal points outwards. */
export interface Face {
  normal: Vector;
  offset: number;
}

export interface HalfSpace extends Face {
  kind: 'halfSpace';
}

export interface BoxRegion {
  kind: 'box';
  low: Vector;
  high: Vector;
}

/** All points with |axes[i] . (p - centre)| <= half[i] for each i. */
export interface OrientedBox {
  kind: 'orientedBox';
  centre: Vector;
  axes?: readonly Vector[]; // x, y, z
  half: Vector;
}

/** All points behind all faces. At most 64 faces. */
export interface ConvexPolyhedron {
  kind: 'polyhedron';
  faces: readonly Face[];
}

export interface Sphere {
  kind: 'sphere';
  centre: Vector;
  radius: number;
}

/** All points at most `radius` from the segment a b. */
export interface Capsule {
  kind: 'capsule';
  a: Vector;
  b: Vector;
  radius: number;
}

/** The frustum of a camera. */
export interface Frustum {
  kind: 'frustum';
  /** 16 numbers in column-major order: in three.js, projectionMatrix times matrixWorldInverse. */
  viewProjection: Vector;
  /** Range of depth after the division by w. WebGPU uses 'zeroToOne'. */
  depth?: 'minusOneToOne' | 'zeroToOne'; // minusOneToOne
}

export interface TrianglesInRegion {
  /** Triangles that share at least one point with the region, in ascending order. */
  readonly intersecting: Uint32Array;
  /** The triangles in `intersecting` that lie wholly inside the region. */
  readonly inside: Uint32Array;
  readonly stats: QueryStats;
}
