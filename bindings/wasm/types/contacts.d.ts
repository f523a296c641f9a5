/** What a query of contacts is asked and what it finds. */

export interface CollideOptions {
  /** Stop at the first contact; `stats.cutShort` tells. */
  firstContact?: boolean;
  /** Stop after so many, at least 1. */
  maxContacts?: number;
}

/** The work of a query, in counts that are the same on every machine. */
export interface QueryStats {
  /** Nodes compared with nodes. */
  readonly nodePairs: number;
  /** Boxes computed for the current palettes. */
  readonly refits: number;
  /** Vertices skinned, once for each node that has them. */
  readonly posedVertices: number;
  readonly trianglePairs: number;
  /** By active morph targets. */
  readonly displacements: number;
  readonly cutShort: boolean;
}

export interface Contacts {
  readonly count: number;
  /** [N][2] triangles of `a` and `b`, ascending. */
  readonly pairs: Uint32Array;
  readonly stats: QueryStats;
}

export const ContactKind: {
  readonly segment: 0;
  readonly point: 1;
  /** They overlap, or touch, in one plane; there are no ends. */
  readonly coplanar: 2;
  /** One triangle has collapsed to a segment or a point; there are no ends. */
  readonly collapsed: 3;
};

export interface ContactGeometry {
  /** [N][6] the ends of the segment that the triangles of contact i share. */
  readonly segments: Float32Array;
  /** [N] a ContactKind each. */
  readonly kinds: Uint8Array;
  /** [N][3] in which direction a should move to leave b. */
  readonly normals: Float32Array;
  /** [N] how far a's triangle reaches behind b's. */
  readonly depths: Float32Array;
  /** [N][2] joints of a and b, into `jointNames`. */
  readonly joints: Uint16Array;
  readonly curves: readonly ContactCurve[];
  /** The one with the most contacts first. */
  readonly regions: readonly ContactRegion[];
}

/** Where the surfaces cut each other, as a line. */
export interface ContactCurve {
  readonly isClosed: boolean;
  /** [K][3]; of a closed curve the last point is the first. */
  readonly points: Float32Array;
}

/** Contacts that hang together. */
export interface ContactRegion {
  /** Numbers of its contacts, into `pairs`. */
  readonly contacts: Uint32Array;
  readonly length: number;
  readonly depth: number;
  readonly point: readonly [number, number, number];
  readonly normal: readonly [number, number, number];
  /** That most of the contacts name, into `jointNames`. */
  readonly jointA: number;
  readonly jointB: number;
}
