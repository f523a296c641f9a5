/**
 * Exact collision detection for skinned characters, in the browser, in Web Workers and in Node.
 *
 * A Character is read or generated, a Pose moves it, a query asks two Poses, Contacts come out: the
 * very ones that the C++ library finds, bit for bit. Terms are those of its headers.
 *
 * Arrays are typed and flat; a shape [N][3] has the element (i, j) at 3 * i + j. Matrices are 16
 * floats, column-major, as three.js and glTF have them. What is returned belongs to the caller (and
 * can be transferred to another thread); an `out` of the right length is written instead of a new
 * array where one is offered.
 *
 * What breaks a rule (an array too short, NaN, a pose of another engine, an option that there is not)
 * is refused by a PeltError, which leaves everything as it was. Only if the engine runs out of memory
 * in the midst of a call, or fails, is it at its end: `Pelt.hasEnded` says so, and every later call
 * of it and of its objects is refused by a PeltError with the code 'engine_ended'. `delete()` still
 * may be called, and arrays that have been returned stay good.
 *
 * Characters, poses, crowds and hashes live in the engine's memory, which has 2 GB at most. `delete()`
 * gives theirs back at once; what is forgotten is given back when JavaScript's garbage collector
 * finds it.
 */

/** Loads the engine: a module with memory of its own. A Web Worker loads its own. */
export function loadPelt(): Promise<Pelt>;

export type ErrorCode =
  /** An argument breaks a stated rule. */
  | 'invalid_argument'
  /** A file is missing. */
  | 'unreadable_file'
  /** A file breaks its format. */
  | 'malformed_file'
  /** A file is well-formed but needs something that Pelt does not do. */
  | 'unsupported'
  /** The engine's memory does not suffice; see `Pelt.hasEnded` for whether it can be used on. */
  | 'out_of_memory'
  /** The engine has failed, or is called after its end: load a new one. */
  | 'engine_ended';

/** The message names the thing (file, array, index, value) and, where there is one, the remedy. */
export class PeltError extends Error {
  private constructor();
  readonly code: ErrorCode;
  /** What a decoder has thrown, or the engine. */
  readonly cause?: unknown;
}

/** The engine. */
export interface Pelt {
  readonly version: string;

  /** Whether it takes no more calls, and a new one has to be loaded. */
  readonly hasEnded: boolean;

  /**
   * A character from the bytes of a glTF file, .glb or .gltf; those of a .gltf's own files, by their
   * names beside it, in `files`. Prepared for queries, which takes some tenths of a second. A file
   * that asks for more than 256 MiB of memory is refused.
   */
  readCharacter(file: Bytes, options: ReadOptions): Character;

  /** A walking biped made by code, 1.8 units tall, facing +z, with the clips "walk" and "idle". */
  generateCreature(options?: CreatureOptions): Character;

  /** A face made by code that has morph targets, with the clip "talk". */
  generateFace(options?: FaceOptions): Character;

  /**
   * A scene as the command `pelt` reads it (docs/scenes.md), and prepared as by `pelt check`, so that
   * contacts and counters are the same. `files` has the file `path` and all that it names, by
   * paths in one folder that has them all: "scenes/duel.json" may name "../models/knight.glb", which
   * is "models/knight.glb" then.
   */
  readScene(path: string, files: Files, options?: ModelOptions): Scene;

  /** A scene of one's own: a copy of the parts, which may then be changed in it at any time. */
  makeScene(parts: SceneParts): Scene;

  /** The text of the scene of `pelt demo`: two generated characters walk into each other. */
  readonly demoScene: string;

  /** Every pair of triangles that intersect, ascending. Preconditions: two different poses. */
  collide(a: Pose, b: Pose, options?: CollideOptions): Contacts;

  /** Whether any do. */
  intersects(a: Pose, b: Pose): boolean;

  /**
   * The same contacts as an engine without refit on demand finds them: all vertices skinned, the
   * exact boxes of all nodes taken bottom-up, then the same descent. A pose that has not been refitted
   * since its palette was set is, which counts as work of this query (see `Pose.refitAll`). Poses keep
   * what queries on demand have opened.
   */
  collideEagerly(a: Pose, b: Pose, options?: CollideOptions): Contacts;

  /**
   * Where and how the contacts' triangles cut each other, chained to curves and gathered to regions.
   * `pairs` are those of `collide`, in the poses as they are now.
   */
  describeContacts(a: Pose, b: Pose, pairs: Uint32Array): ContactGeometry;

  /** The least distance of two posed surfaces; null if it is more than `maxDistance`. */
  distance(a: Pose, b: Pose, options?: DistanceOptions): Distance | null;

  /** Every pair of triangles that are at most `tolerance` apart, ascending; those of `collide` for 0. */
  clearance(a: Pose, b: Pose, tolerance: number, options?: CollideOptions): Contacts;

  /** Whether there is any. */
  isWithin(a: Pose, b: Pose, tolerance: number): boolean;

  /**
   * The vertex of `a` that is inside `b` and furthest from its surface; null: none is inside. `b` must
   * be closed (see `Pose.isClosed`).
   */
  deepestVertex(a: Pose, b: Pose): Penetration | null;

  /**
   * Whether one body holds the other whole, which no contact tells: 'none' where they touch, too. What
   * is not closed holds nothing.
   */
  containment(a: Pose, b: Pose): 'none' | 'a_in_b' | 'b_in_a';

  /** Many instances at once, as `pelt check` asks them. */
  makeCrowd(): Crowd;

  /** The hash that `pelt check` prints. */
  makeContactHash(): ContactHash;
}

export type Bytes = ArrayBuffer | ArrayBufferView;

/** By their paths in one folder, which they do not leave. */
export type Files = ReadonlyMap<string, Bytes> | Readonly<Record<string, Bytes>>;

/**
 * `MeshoptDecoder.decodeGltfBuffer` of the npm package meshoptimizer, once its `ready` is. What it
 * throws is the `cause` of the PeltError that follows. It may not call the engine.
 */
export type MeshoptDecode = (
  target: Uint8Array,
  count: number,
  size: number,
  source: Uint8Array,
  mode: string,
  filter?: string,
) => void;

export interface ModelOptions {
  /** For files compressed by EXT_meshopt_compression; without it they are refused. */
  meshoptDecode?: MeshoptDecode;
  /** Accept weights that do not sum to 1: divide them by their sum, as renderers do. */
  renormalise?: boolean;
  /** Leave out meshes without a skin (weapons, armour). */
  noUnskinned?: boolean;
  /** Names of mesh nodes to leave out, with their children. */
  exclude?: readonly string[];
  /** Poses taken from the clips to prepare for; no answer depends on it. Default 6. */
  samples?: number;
}

export interface ReadOptions extends ModelOptions {
  /** What messages and tables call it. */
  name: string;
  files?: Files;
  /** The clips to prepare for; default: the first ones. */
  clips?: readonly string[];
}

export interface CreatureOptions {
  name?: string; // "creature"
  clips?: readonly string[]; // as in ReadOptions, and the next too
  samples?: number;
  triangles?: number; // 1,000 to 1,000,000; default 13,590
  joints?: number; // 20 to 64; default 56
  seed?: number; // proportions; default 1
}

export interface FaceOptions {
  name?: string; // "face"
  clips?: readonly string[]; // as in ReadOptions, and the next too
  samples?: number;
  triangles?: number; // 1,000 to 200,000; default 4,000
  seed?: number; // default 1
}

/** A range of triangles that came from one primitive of the file. */
export interface Part {
  /** Of its node, "node:material" where several share that; as `pelt check` names it. */
  readonly name: string;
  readonly firstTriangle: number;
  readonly triangleCount: number;
  readonly skinned: boolean;
}

export interface Clip {
  readonly name: string;
  readonly seconds: number;
}

export interface Character {
  /** As it was given when it was read; names a character of a scene. */
  readonly name: string;
  readonly vertexCount: number;
  readonly triangleCount: number;
  readonly jointCount: number;
  /** Of the tree over the triangles. */
  readonly nodeCount: number;
  /** Of the tree: `Pose.nodeBoxes` takes the levels 0 to levelCount - 1. */
  readonly levelCount: number;
  readonly parts: readonly Part[];
  readonly clips: readonly Clip[];
  /** [J] "joint 7" where the file has no name. */
  readonly jointNames: readonly string[];
  /** [M] */
  readonly morphTargetNames: readonly string[];
  /** What the file has and Pelt passed over. */
  readonly warnings: readonly string[];
  /** [T][3] indices of vertices. A copy is made at the first use, as with the next three. */
  readonly triangles: Uint32Array;
  /** [V][3] before skinning. */
  readonly restPositions: Float32Array;
  /** [T] into `parts`. */
  readonly triangleParts: Uint16Array;
  /** [T] into `jointNames`: the joint that a triangle's corners follow most. */
  readonly triangleJoints: Uint16Array;
  /** Of the default pose. */
  readonly extent: Box;

  /**
   * [J] matrices at `seconds` of a clip, clamped to its range; null: the default pose. `placement`
   * stands before everything, as the instance's world matrix.
   */
  palette(
    clip: string | null,
    seconds: number,
    placement?: ArrayLike<number>,
    out?: Float32Array,
  ): Float32Array;

  /** [M] weights of the morph targets as the clip has them. */
  morphWeights(clip: string | null, seconds: number, out?: Float32Array): Float32Array;

  /**
   * In the rest positions at first. Poses may outlive their character's `delete`. With an index into
   * `parts` only that part collides, and is prepared for that at the first use; all else, numbers of
   * triangles too, is as of the whole. A part without triangles is refused.
   */
  makePose(part?: number | null): Pose;

  delete(): void;
}

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

/**
 * Where a character stands in a scene and what it plays, as in a scene file. Plain data, which is
 * checked whenever it is used: other keys are refused, and numbers beyond 1e12.
 */
export interface Instance {
  /** Index into `Scene.characters`. */
  character: number;
  /** null: the default pose. */
  clip: string | null;
  /** Clip time = (start + speed * time) modulo the clip's length. */
  start: number; // 0
  speed: number; // 1
  translation: [number, number, number]; // 0 0 0
  rotation: [number, number, number, number]; // quaternion x y z w, any length but 0; 0 0 0 1
  scale: number; // 1e-6 to 1e6; 1
  velocity: [number, number, number]; // units per second; 0 0 0
  /** Weights that morph targets keep, whatever the clip plays: by name, or number of the target. */
  morphWeights: Record<string, number>; // none
}

export interface SceneParts {
  name?: string;
  characters: Character[];
  /** What is left out has the default that stands beside it. */
  instances: (Pick<Instance, 'character'> & Partial<Instance>)[];
  frameCount?: number; // at least 1; 1
  fps?: number; // 1e-6 to 1e6; 30
  ignore?: NamePair[]; // none
}

/**
 * Names of parts or joints whose contacts with each other do not count, as in a scene file
 * (docs/scenes.md): `*` stands for any characters, "knight/Cape" is a name of one character alone.
 */
export type NamePair = readonly [string, string];

/** Characters, where they stand and what they play. */
export interface Scene {
  readonly name: string;
  characters: Character[];
  /** May be changed, added to and removed from at any time. */
  instances: Instance[];
  frameCount: number;
  fps: number;
  /** For `Crowd.ignore`: a scene itself asks nothing. */
  ignore: NamePair[];

  /** [J] matrices of an instance at a frame, bit for bit those of `pelt check`. */
  palette(instance: number, frame: number, out?: Float32Array): Float32Array;
  morphWeights(instance: number, frame: number, out?: Float32Array): Float32Array;

  /** Gives a pose, of the instance's character, its palette and morph weights. */
  setPose(pose: Pose, instance: number, frame: number): void;

  /** Deletes its characters. */
  delete(): void;
}

/** Instances that are asked for all their contacts at once. */
export interface Crowd {
  /** Adds an instance and returns its number. With a part only that collides, as in `makePose`. */
  add(character: Character, part?: number | null): number;
  setPalette(instance: number, palette: Float32Array): void;
  setMorphWeights(instance: number, weights: Float32Array): void;
  /**
   * From now on `collide` leaves out contacts of what these names mean, and none else; what is added
   * later, too. A name that nothing has means nothing (`readScene` refuses it). Where anything is
   * ignored, `collide` takes no limit: the contacts found first may be those to ignore.
   */
  ignore(pairs: readonly NamePair[]): void;
  /** All pairs of triangles of any two instances that intersect; `maxContacts` is of each two. */
  collide(options?: CollideOptions): CrowdContacts;
  delete(): void;
}

export interface CrowdContacts {
  readonly count: number;
  /** [N][4] instances a < b and triangles of a and b, ascending. */
  readonly contacts: Uint32Array;
  /** How many more there are that do not count. */
  readonly ignored: number;
  readonly stats: QueryStats;
}

/** FNV-1a 64 of all contacts of a run: the same for the same answer, as `pelt check` prints it. */
export interface ContactHash {
  /** Contacts of the instances a < b in a frame; frames, a and b ascending. */
  add(frame: number, a: number, b: number, pairs: Uint32Array): void;
  /** All contacts of a crowd in a frame. */
  addCrowd(frame: number, contacts: Uint32Array): void;
  /** 16 hexadecimal digits. */
  readonly value: string;
  delete(): void;
}
