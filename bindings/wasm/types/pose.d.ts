/** A pose, its boxes, and rays that hit it. */

import type { Character } from './character.js';
import type { QueryStats } from './contacts.js';
import type { ClosestPoint, ClosestPointOptions } from './distances.js';
import type { Region, TrianglesInRegion, Vector } from './regions.js';

/** One instance of a character in one posture. */
export interface Pose {
  readonly character: Character;
  /** What of it collides; null: all parts together. */
  readonly part: number | null;

  /** [J] matrices. This and the next are the whole update: nothing has to be refitted. */
  setPalette(palette: Float32Array): void;
  setMorphWeights(weights: Float32Array): void;

  /** [V][3] the very positions that queries collide. */
  posedVertices(out?: Float32Array): Float32Array;

  /**
   * [V][3] area weighted normals of unit length, for drawing; vertices in the same place share
   * theirs, so that no seam shows.
   */
  normals(out?: Float32Array): Float32Array;

  /**
   * Skins all vertices and takes the exact boxes of all nodes, for `collideEagerly`: once a frame, an
   * engine without refit on demand does that to every instance. To compare with.
   */
  refitAll(): QueryStats;

  /** A box and a sphere that surely enclose the surface, from the palette and `levels` of the tree. */
  bounds(levels?: number): Bounds;
  /** The box is exact. */
  tightBounds(): Bounds;

  /** Of the tree over the triangles that collide. */
  readonly nodeCount: number;

  /** How many nodes queries have opened since the palette was set. */
  readonly openedNodeCount: number;

  /**
   * The boxes of one level of the tree in this pose, and what queries have done with them since the
   * palette was set: Kavan & Zara's Figure 5. Level 0 is the root. Where a branch ends above `level`,
   * its end is there: the boxes of each level enclose the whole surface. Opens nothing.
   */
  nodeBoxes(level: number): NodeBoxes;

  /** The first triangle on the ray origin + t direction; null: none. */
  cast(origin: Vector, direction: Vector, options?: CastOptions): RayHit | null;
  /** Whether there is any. */
  castAny(origin: Vector, direction: Vector, options?: CastOptions): boolean;
  /** All of them, by t. An edge that two triangles share is met twice. */
  castAll(origin: Vector, direction: Vector, options?: CastOptions): RayHit[];

  /** Where all triangles lie: touching counts, and nothing is rounded. */
  classify(region: Region): 'outside' | 'partly' | 'inside';
  /** Whether any triangle touches the region, which what lies inside does, too. */
  intersectsRegion(region: Region): boolean;
  /** The triangles that do. */
  findTriangles(region: Region): TrianglesInRegion;

  /** The place of the surface that is nearest to a point; null: none within `maxDistance`. */
  closestPoint(point: Vector, options?: ClosestPointOptions): ClosestPoint | null;

  /** Whether the surface has no holes, so that it has an inside. Found out at the first use. */
  readonly isClosed: boolean;
  /** Where a point lies; of closed surfaces only. */
  sideOf(point: Vector): 'outside' | 'on' | 'inside';

  delete(): void;
}

export interface Box {
  readonly low: readonly [number, number, number];
  readonly high: readonly [number, number, number];
}

export interface Bounds {
  readonly box: Box;
  readonly centre: readonly [number, number, number];
  readonly radius: number;
}

export interface NodeBoxes {
  readonly count: number;
  /** [N][6] low x y z, high x y z. */
  readonly boxes: Float32Array;
  /** [N] a NodeState each. */
  readonly states: Uint8Array;
}

export const NodeState: {
  /** No query has come near: the box has not been asked for. */
  readonly untouched: 0;
  /** The box has been refitted, because what is around it was opened, and that was enough. */
  readonly refitted: 1;
  /** What is inside has been asked for: vertices are skinned, boxes inside refitted. */
  readonly opened: 2;
};

export interface RayHit {
  readonly triangle: number;
  readonly t: number;
  /** Of the triangle's corners. */
  readonly weights: readonly [number, number, number];
  readonly normal: readonly [number, number, number];
}

export interface CastOptions {
  /** Hits have minT <= t <= maxT. */
  minT?: number; // 0
  maxT?: number; // Infinity
  /** From which side triangles are hit; from their front, corners are seen counter-clockwise. */
  facing?: 'both' | 'front' | 'back'; // both
}
