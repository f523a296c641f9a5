/**
 * The messages between the page and its worker. The worker has the characters but not the state of
 * the page, so a request contains everything that its answer depends on.
 */

import type { Box, Clip, LeftOut } from 'pelt';
import type { ModelSource, Scene, SelfChoices, Skinning } from '../scene/types';

export interface NamedFile {
  /** Path in the scene file, or of the dropped file. */
  path: string;
  bytes: Uint8Array<ArrayBuffer>;
}

/** The others are what characters refer to. */
export function isCharacter({ path }: Pick<NamedFile, 'path'>): boolean {
  return /\.(glb|gltf)$/i.test(path);
}

/** How the command read the models; see `ModelOptions` of the engine. */
export interface ReadingOptions {
  renormalise?: boolean;
  noUnskinned?: boolean;
  exclude?: string[];
  samples?: number;
  /** Of all models. Absent: as the scene says. */
  skinning?: Skinning;
}

/** What is tested: instances against each other, or parts, including parts of the same instance. */
export type By = 'instance' | 'part';

export type FrameRange = [first: number, end: number, step: number];

/** How bodies, which are instances or parts, are tested against themselves. */
export interface SelfQuestion {
  /** No two bodies are tested against each other. */
  isOnly: boolean;
  /** Triangles that a chain of fewer others connects do not count. */
  rings: number;
  dropsAtRest: boolean;
  /** Pairs of triangles that touch in at least this share of `frames` do not count; null: all do. */
  always: number | null;
  dropsNearJoints: boolean;
  /** Null for all frames, and if `always` is null. */
  frames: FrameRange | null;
}

/** A time between two frames, at which triangles first touch. */
export interface Moment {
  /** The frame in which the step ends. */
  to: number;
  /** The share of the step that has passed. */
  share: number;
  /** Seconds from the start of the scene. */
  seconds: number;
  /** Instances and triangles that touch, and whether a body touches itself. */
  a: number;
  b: number;
  triangles: [number, number];
  isOfSelf: boolean;
}

/** A step between two checked frames in which triangles touch that touch in neither of them. */
export interface Step {
  /** The frame in which the step begins. */
  frame: number;
  /** Contacts that touch in neither frame. */
  contacts: number;
  /** When the first of them touches. */
  first: Moment;
}

/** A frame of a scene, and its query; or a time after it. */
export interface Shot {
  scene: Scene;
  frame: number;
  /** Between this frame and a later one. No query is asked: the answer has this contact only. */
  moment: Moment | null;
  by: By;
  /** Most contacts of each pair of bodies, and of each body with itself; null for all. */
  maxContacts: number | null;
  /** Largest distance of two triangles in contact; null if they have to touch. */
  clearance: number | null;
  /** Units of work for each pair of bodies, after which contacts may be missing; null: no limit. */
  budget: number | null;
  /** Null: no body is tested against itself. */
  self: SelfQuestion | null;
  /** Level of the trees whose boxes are drawn. */
  boxLevel: number | null;
  /** The contacts that are wanted one by one. */
  spot: Spot | null;
}

/** Which contacts of two bodies are found. */
export type ContactQuestion = Pick<Shot, 'maxContacts' | 'clearance' | 'budget'>;

/** Arguments of each kind of request. */
export interface Questions {
  /** The scene that the page opens with. */
  openDemo: Record<never, never>;
  /** A scene file, with the files that it names; replaces all characters. */
  openScene: { path: string; files: NamedFile[]; options: ReadingOptions };
  /** The same from a report, whose files are base64 by their paths. */
  openReport: { path: string; files: Record<string, string>; options: ReadingOptions };
  /** Characters without a scene; replaces all others. */
  readCharacters: { files: NamedFile[]; options: ReadingOptions };
  /** The same, beside those that there are. */
  addCharacters: { files: NamedFile[]; options: ReadingOptions };
  pose: { shot: Shot; spares: Spare[] };
  /** Like `pose`, for a frame that is not displayed. */
  still: Shot;
  /** Bit by bit: the same again until there is an answer. Each measurement has its own number. */
  measure: { id: number; shot: Shot };
  /** Finds the triangle that a ray hits first, in the poses of the last `pose` without the hidden
   * instances. */
  cast: { origin: number[]; direction: number[]; hidden: readonly number[] };
  /** Counts the contacts of the frames in the background, and ends the sweep before. Answered when
   * that is done or ended. */
  sweep: {
    id: number;
    scene: Scene;
    by: By;
    maxContacts: number | null;
    clearance: number | null;
    budget: number | null;
    self: SelfQuestion | null;
    /** Whether the steps between the frames are tested, too. Not with a limit or a clearance. */
    between: boolean;
    /** Frames to be counted, or null for all frames. */
    frames: FrameRange | null;
  };
}

export interface Answers {
  openDemo: Opened;
  openScene: Opened;
  openReport: Opened;
  readCharacters: Opened;
  addCharacters: ReadCharacters;
  pose: FrameAnswer;
  still: StillAnswer;
  measure: Costs | null;
  cast: Surface | null;
  sweep: null;
}

export type Kind = keyof Questions;

export type Request = { [K in Kind]: { id: number; kind: K; question: Questions[K] } }[Kind];

export type Reply =
  | { id: number; answer: Answers[Kind] }
  | { id: number; problem: string }
  | { progress: SweepProgress };

/** Characters that the worker has read, and files beside them that are none. */
export interface ReadCharacters {
  characters: CharacterFacts[];
  refused: Refusal[];
}

/** All characters with their scene; without a scene, the page places them. */
export interface Opened extends ReadCharacters {
  scene: Scene | null;
  /** Choices of the scene file. */
  self: SelfChoices;
}

export interface Refusal {
  path: string;
  /** Error message. */
  message: string;
}

/** Facts about a character for the page. */
export interface CharacterFacts {
  name: string;
  source: ModelSource;
  triangles: Uint32Array;
  vertexCount: number;
  levelCount: number;
  /** Number of parts with triangles. */
  partCount: number;
  clips: readonly Clip[];
  extent: Box;
  warnings: readonly string[];
}

/** A place on a character: a part and the joint that it follows most there. */
export interface Surface {
  instance: number;
  part: string;
  joint: string;
}

/** Two such places, in ascending order. */
export interface Spot {
  a: Surface;
  b: Surface;
}

/** Contacts between them. */
export interface Touch extends Spot {
  contacts: number;
  /** The frame with the most of them. */
  worst: { frame: number; contacts: number };
}

/** The work of a query, counted as by the command, and the work of refitting everything. */
export interface Work {
  refits: number;
  allRefits: number;
  posedVertices: number;
  allVertices: number;
  trianglePairs: number;
}

/** Arrays returned by the page for reuse. */
export interface Spare {
  positions: Float32Array;
  normals: Float32Array;
}

export interface PosedInstance {
  positions: Float32Array;
  normals: Float32Array;
  boxes: Float32Array;
  boxStates: Uint8Array;
}

/** All triangles in contact. The arrays may be longer than their content. */
export interface Glow {
  triangles: number;
  /** The first triangles are of contacts of bodies with themselves. */
  ofSelf: number;
  /** [T][3][3] positions, and [T][3] of their middles. */
  corners: Float32Array;
  centres: Float32Array;
}

/** A frame to be photographed. */
export interface StillAnswer extends FrameAnswer {
  /** How many of its contacts are visible from each of `SIDES`. */
  seen: number[];
}

/** The closest points of two bodies, and where they are. */
export interface ClosestPoints extends Spot {
  distance: number;
  /** Coordinates of the point of a, and of that of b. */
  points: number[];
}

/** The contacts of a spot. */
export interface SpotAnswer {
  /** [N][2] triangles of its first and its second place. */
  pairs: Uint32Array;
  glow: Glow;
  /** How many of them are visible from each of `SIDES`. */
  seen: number[];
}

export interface FrameAnswer {
  instances: PosedInstance[];
  glow: Glow;
  contacts: number;
  /** Contacts of bodies with themselves, which are among `contacts`. */
  selfContacts: number;
  /** What the filters of contacts of bodies with themselves have left out. */
  leftOut: LeftOut;
  /** Contacts of bodies with themselves are missing until the sweep has made their filters. */
  isPreliminary: boolean;
  /** Contacts that do not count. */
  ignored: number;
  /** Pairs of triangles that the budget has left undecided; 0 without a budget. */
  undecided: number;
  /** The most contacts first. */
  touches: Touch[];
  spot: SpotAnswer | null;
  /** Of pairs of bodies with contacts, the closest first; empty without a clearance. */
  closest: ClosestPoints[];
  work: Work;
}

/** Cost of one frame's query, on demand and with everything refitted. */
export interface Costs {
  onDemand: Cost;
  eager: Cost;
  /** Nodes opened on demand, out of all nodes. */
  openedNodes: number;
  nodes: number;
}

export interface Cost {
  microseconds: number;
  trianglePairs: number;
}

export interface SweepProgress {
  id: number;
  /** Number of frames in which contacts were looked for that are in nearly all frames. */
  searched: number;
  /** Contacts of the frames after those of the progress before; null for frames left out. */
  counts: (number | null)[];
  /** Contacts of bodies with themselves, which are among these. */
  selfCounts: (number | null)[];
  /** Pairs of triangles that the budget has left undecided; null for frames left out. */
  undecided: (number | null)[];
  /** Steps that end in these frames, of those with contacts between frames only. */
  steps: Step[];
  /** Sent with the last frame. */
  total: SweepTotal | null;
}

export interface SweepTotal {
  /** See FrameAnswer. */
  leftOut: LeftOut;
  /** Hash as in `pelt check`; null if contacts are limited, or if pairs are undecided. */
  hash: string | null;
  /** The same of contacts between frames; null if steps were not tested. */
  betweenHash: string | null;
  /** Contacts that do not count. */
  ignored: number;
  touches: Touch[];
}
