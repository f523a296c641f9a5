/** Options and results of queries of two poses: contacts and distances. */

export interface CollideOptions {
  /** Stop at the first contact. `stats.cutShort` says whether any may be missing. */
  firstContact?: boolean;
  /** Stop after this number of contacts, at least 1. `stats.cutShort` says whether any may be missing. */
  maxContacts?: number;
}

/** Work done by a query. The counts are the same on every machine. */
export interface QueryStats {
  /** Tests of a node against the other operand: a node of another tree, a ray, a point or a region. */
  readonly nodePairs: number;
  /** Boxes computed for the current palettes. */
  readonly refits: number;
  /** Vertices skinned. A vertex that triangles of several nodes share counts once per node. */
  readonly posedVertices: number;
  /** Tests of a triangle against the other operand. */
  readonly trianglePairs: number;
  /** Displacements by active morph targets. */
  readonly displacements: number;
  /** Offsets of skinned vertices that were clamped to their caps (see `Pose.setOffsets`). */
  readonly clampedOffsets: number;
  /** Whether a limit in the options ended the query early, so that results may be missing. */
  readonly cutShort: boolean;
}

export interface Contacts {
  readonly count: number;
  /** [N][2] Triangles of `a` and `b`, in ascending order. */
  readonly pairs: Uint32Array;
  readonly stats: QueryStats;
}

export const ContactKind: {
  /** The triangles intersect in a segment. */
  readonly segment: 0;
  /** The triangles touch in one point. */
  readonly point: 1;
  /** The triangles overlap or touch in one plane. */
  readonly coplanar: 2;
  /** A triangle has collapsed to a segment or a point. */
  readonly collapsed: 3;
};

export interface ContactGeometry {
  /**
   * [N][6] Both ends of the segment in which the triangles intersect. For kind `point`, both ends are that
   * point. For kinds `coplanar` and `collapsed`, both ends are the midpoint between the centres of the
   * triangles.
   */
  readonly segments: Float32Array;
  /** [N] A ContactKind. */
  readonly kinds: Uint8Array;
  /**
   * [N][3] Direction in which `a` should move to leave `b`: the unit vector along n_b - n_a, where n_a
   * and n_b are the unit normals of the triangles. If both normals are equal, this is n_b. The normal
   * of a collapsed triangle counts as zero. If both triangles have collapsed, this is zero.
   */
  readonly normals: Float32Array;
  /**
   * [N] Overlap of the two triangles along the normal. After the triangle of `a` has moved this far
   * along the normal, the triangles at most touch. A finer mesh gives a smaller depth. For the depth of
   * one body inside another, see `Pelt.deepestVertex`.
   */
  readonly depths: Float32Array;
  /**
   * [N][2] Main joints of the triangles of `a` and `b`, as indices into `jointNames`. The main joint of
   * a triangle is the joint with the largest sum of weights over the triangle's vertices.
   */
  readonly joints: Uint16Array;
  readonly curves: readonly ContactCurve[];
  /** The patch with the most contacts comes first. */
  readonly patches: readonly ContactPatch[];
}

/** A curve in which the surfaces intersect. */
export interface ContactCurve {
  readonly isClosed: boolean;
  /** [K][3] The last point of a closed curve equals the first. */
  readonly points: Float32Array;
}

/**
 * A connected set of contacts. Two contacts are neighbours if they share one triangle and their other
 * triangles share a vertex.
 *
 * Contacts of a pose with itself: in each contact of a patch, one triangle is on side a and the other
 * triangle is on side b. A triangle that two neighbouring contacts share is on the same side in both.
 * In the first contact of the patch, the triangle with the lower number is on side a. A contact whose
 * lower triangle is on side b contributes to `normal`, `jointA` and `jointB` with its normal negated
 * and its joints exchanged. If these rules would put both triangles of a contact on both sides, the
 * patch has no sides, and all contacts contribute unchanged.
 */
export interface ContactPatch {
  /** Indices of its contacts in `pairs`, ascending. */
  readonly contacts: Uint32Array;
  /**
   * Sum of the lengths of all segments: the length of the line in which the surfaces intersect. Does not
   * depend on the size of the triangles. To sort patches by severity, sort by length.
   */
  readonly length: number;
  /** The largest depth of the contacts. One large triangle with a small overlap may give a large depth. */
  readonly depth: number;
  /** Mean of the midpoints of the segments, weighted by length. */
  readonly point: readonly [number, number, number];
  /** Unit vector along the mean of the normals, weighted by length. Zero if they cancel. */
  readonly normal: readonly [number, number, number];
  /** The most frequent joint of each side, as an index into `jointNames`. */
  readonly jointA: number;
  readonly jointB: number;
}

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
