/** Options and results of contact queries. */

export interface CollideOptions {
  /** Stop at the first contact. `stats.cutShort` is then true. */
  firstContact?: boolean;
  /** Stop after this number of contacts, at least 1. */
  maxContacts?: number;
}

/** Work done by a query. The counts are the same on every machine. */
export interface QueryStats {
  /** Pairs of nodes tested for overlap. */
  readonly nodePairs: number;
  /** Boxes computed for the current palettes. */
  readonly refits: number;
  /** Vertices skinned; a vertex counts once for each node that contains it. */
  readonly posedVertices: number;
  readonly trianglePairs: number;
  /** Displacements by active morph targets. */
  readonly displacements: number;
  readonly cutShort: boolean;
}

export interface Contacts {
  readonly count: number;
  /** [N][2] Triangles of `a` and `b`, in ascending order. */
  readonly pairs: Uint32Array;
  readonly stats: QueryStats;
}

export const ContactKind: {
  readonly segment: 0;
  readonly point: 1;
  /** The triangles overlap or touch in one plane. There are no end points. */
  readonly coplanar: 2;
  /** A triangle has collapsed to a segment or a point. There are no end points. */
  readonly collapsed: 3;
};

export interface ContactGeometry {
  /** [N][6] End points of the segment of intersection of contact i. */
  readonly segments: Float32Array;
  /** [N] A ContactKind. */
  readonly kinds: Uint8Array;
  /** [N][3] Direction in which a must move to leave b. */
  readonly normals: Float32Array;
  /** [N] How far the triangle of a reaches behind the triangle of b. */
  readonly depths: Float32Array;
  /** [N][2] Joints of a and b, as indices into `jointNames`. */
  readonly joints: Uint16Array;
  readonly curves: readonly ContactCurve[];
  /** In descending order of their numbers of contacts. */
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
  readonly length: number;
  readonly depth: number;
  readonly point: readonly [number, number, number];
  readonly normal: readonly [number, number, number];
  /** The joints that occur in most of the contacts, as indices into `jointNames`. */
  readonly jointA: number;
  readonly jointB: number;
}
