/** Poses, their boxes, and the queries of a single pose. */

import type { Character } from './character.js';
import type { ClosestPoint, ClosestPointOptions, QueryStats } from './queries.js';
import type { Region, TrianglesInRegion, Vector } from './regions.js';

/** One instance of a character with a joint palette. */
export interface Pose {
  readonly character: Character;
  /** The part that collides, or null for the whole character. */
  readonly part: number | null;

  /** Copies [J] matrices of a joint palette. Each double is rounded once, to the nearest float. */
  setPalette(palette: Float32Array | Float64Array): void;
  /**
   * Copies [J][8] dual quaternions: the rotation x y z w, then the dual part. Only for characters with
   * the option skinning: 'dual-quaternion', which also accept palettes of rigid matrices.
   */
  setDualQuaternions(dualQuaternions: Float32Array): void;
  /** Copies [M] morph weights. */
  setMorphWeights(weights: Float32Array): void;

  /**
   * Copies [V][3] positions of all vertices, in the frame shared by all poses of a query. All queries then
   * answer as if joints had posed the vertices to these positions. Use this for cloth, simulations and other
   * surfaces that do not follow joints. A pose of a part also takes the vertices of the whole character.
   * `setPalette`, `setDualQuaternions`, `setMorphWeights`, `setOffsets` and `Scene.setPose` end this. Rejects
   * coordinates that are NaN or beyond 2^60, and vertices that differ although the character has merged them
   * (see `ModelOptions.weld`).
   */
  setVertices(vertices: Float32Array): void;
  /**
   * Copies [V][3] offsets, which are added to the vertices after the joints have posed them, in the frame
   * shared by all poses of a query. Offsets remain until the next call; null removes them. Each coordinate is
   * clamped to the cap of the vertex, and NaN counts as 0; `checkOffsets` and `QueryStats.clampedOffsets`
   * count the vertices where this happens. Queries add only the offsets of vertices that they skin. Rejects
   * offsets if the character has no caps (see `ReadOptions.offsetCaps`).
   */
  setOffsets(offsets: Float32Array | null): void;
  /** Returns the number of vertices whose offset is clamped. */
  checkOffsets(): number;

  /** Returns [V][3] posed positions, exactly as queries use them. */
  posedVertices(out?: Float32Array): Float32Array;

  /**
   * Returns [V][3] area-weighted unit normals for rendering. Vertices at the same position have the same
   * normal, so seams are invisible.
   */
  normals(out?: Float32Array): Float32Array;

  /**
   * Skins all vertices and computes the exact boxes of all nodes, for `collideEagerly`. A library that
   * does not compute boxes on demand does this for every instance in every frame. For comparisons.
   */
  openAll(): QueryStats;

  /**
   * Returns a box and a sphere that are guaranteed to enclose the surface. With `levels` 0, the default,
   * they are computed from the palette and the morph weights, without posing vertices. Otherwise opens
   * up to `levels` levels of the tree for smaller bounds.
   */
  bounds(levels?: number): Bounds;
  /** Like `bounds`, with an exact box. */
  exactBounds(): Bounds;

  /** Number of nodes of the tree over the triangles that collide. */
  readonly nodeCount: number;

  /** Number of nodes that queries have opened since the palette was set. */
  readonly openedNodeCount: number;

  /**
   * Returns the boxes of one level of the tree in this pose, as in Figure 5 of Kavan & Zara. The state
   * of each box says how queries have used the box since the palette was set. Level 0 is the root. A
   * branch that ends above `level` contributes its last box, so the boxes of each level enclose the whole
   * surface. Opens no node.
   */
  nodeBoxes(level: number): NodeBoxes;

  /** Returns the first triangle hit by the ray origin + t direction, or null. */
  cast(origin: Vector, direction: Vector, options?: CastOptions): RayHit | null;
  /** Returns whether the ray hits any triangle. */
  castAny(origin: Vector, direction: Vector, options?: CastOptions): boolean;
  /** Returns all hits in the order of t. A shared edge counts as a hit of both triangles. */
  castAll(origin: Vector, direction: Vector, options?: CastOptions): RayHit[];

  /** Returns where the triangles lie. Touching counts. The answer is exact. */
  classify(region: Region): 'outside' | 'partly' | 'inside';
  /** Returns whether any triangle touches the region or lies inside it. */
  intersectsRegion(region: Region): boolean;
  /** Returns the triangles that touch the region or lie inside it. */
  findTriangles(region: Region): TrianglesInRegion;

  /** Returns the point of the surface closest to `point`, or null if none is within `maxDistance`. */
  closestPoint(point: Vector, options?: ClosestPointOptions): ClosestPoint | null;

  /** Whether the surface has no holes and therefore an inside. Computed at the first use. */
  readonly isClosed: boolean;
  /** Returns on which side of the surface a point lies. Precondition: the surface is closed. */
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
  /** [N][6] Low x y z, high x y z. */
  readonly boxes: Float32Array;
  /** [N] A NodeState. */
  readonly states: Uint8Array;
}

export const NodeState: {
  /** No query has needed the box. */
  readonly untouched: 0;
  /** The box was computed when its parent was opened, and no query needed more. */
  readonly refitted: 1;
  /** The node was opened: its vertices were skinned, and the boxes of its slots computed. */
  readonly opened: 2;
};

export interface RayHit {
  readonly triangle: number;
  readonly t: number;
  /** Weights of the vertices of the triangle. */
  readonly weights: readonly [number, number, number];
  readonly normal: readonly [number, number, number];
}

export interface CastOptions {
  /** Hits have minT <= t <= maxT. */
  minT?: number; // 0
  maxT?: number; // Infinity
  /** Side from which triangles can be hit. Vertices appear counter-clockwise from the front. */
  facing?: 'both' | 'front' | 'back'; // both
}
