/** Options and results of contact queries. */

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
  /** [N][3] Direction in which `a` should move to leave `b`. Unit length, or zero. */
  readonly normals: Float32Array;
  /** [N] How far the triangle of `a` reaches behind the triangle of `b` along the normal. */
  readonly depths: Float32Array;
  /** [N][2] Joints that move the triangles of `a` and `b` most, as indices into `jointNames`. */
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

/** A connected set of contacts. */
export interface ContactPatch {
  /** Indices of its contacts in `pairs`. */
  readonly contacts: Uint32Array;
  /** Sum of the lengths of all segments. */
  readonly length: number;
  /** The largest depth of the contacts. */
  readonly depth: number;
  /** Mean of the midpoints of the segments, weighted by length. */
  readonly point: readonly [number, number, number];
  /** Unit vector along the mean of the normals, weighted by length. Zero if they cancel. */
  readonly normal: readonly [number, number, number];
  /** The most frequent joints of the contacts, as indices into `jointNames`. */
  readonly jointA: number;
  readonly jointB: number;
}
