/** Parts of space. */

import type { QueryStats } from './contacts.js';

/** Three numbers. */
export type Vector = readonly number[] | Float32Array | Float64Array;

/** A closed convex set of points, whose numbers are taken in single precision. */
export type Region =
  HalfSpace | BoxRegion | OrientedBox | ConvexPolyhedron | Sphere | Capsule | Frustum;

/** All points with normal . p <= offset: what lies behind a plane whose normal points out. */
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

/** What is behind all faces, of which there are 64 at most. */
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

/** What a camera sees. */
export interface Frustum {
  kind: 'frustum';
  /** 16 numbers, column-major: three.js's projectionMatrix times matrixWorldInverse. */
  viewProjection: Vector;
  /** What lies between the near and the far plane after the division by w; WebGPU's is 'zeroToOne'. */
  depth?: 'minusOneToOne' | 'zeroToOne'; // minusOneToOne
}

export interface TrianglesInRegion {
  /** Numbers of the triangles that have at least a point in common with the region, ascending. */
  readonly touching: Uint32Array;
  /** Of these, those that lie wholly in it. */
  readonly inside: Uint32Array;
  readonly stats: QueryStats;
}
