/** State of the page. Data flows one way: state, request to the worker, answer, picture. */

import type { Finding, Reel, Report, Standing } from '../report/report';
import type { Arrangement } from '../scene/arrange';
import type { Scene, SelfChoices, Vector3 } from '../scene/types';
import type {
  By,
  CharacterFacts,
  Costs,
  FrameAnswer,
  FrameRange,
  Moment,
  ReadingOptions,
  Shot,
  Spot,
  Step,
  Surface,
  SweepTotal,
} from '../worker/protocol';

export interface State {
  scene: Scene | null;
  /** The scene as opened, if it had its own placements. */
  opened: Scene | null;
  /** The most recent placement of all characters. */
  arrangement: Arrangement | 'opened';
  /** The scene that this placement made; another one since it was edited. */
  arranged: Scene | null;
  characters: CharacterFacts[];
  /** Options with which the files were read. */
  readingOptions: ReadingOptions;
  /** Names of the files being read, or null. */
  reading: string | null;

  frame: number;
  /** A time after the frame, of this scene; see `momentOf`. */
  moment: { scene: Scene; frame: number; moment: Moment } | null;
  isPlaying: boolean;
  by: By;
  /** Most contacts of each pair of bodies, and of each body with itself; null for all. */
  maxContacts: number | null;
  /** The most recent limit. */
  lastMaxContacts: number;
  /** Largest distance of two triangles in contact, from a report; null if they have to touch. */
  clearance: number | null;
  /** Units of work for each pair of bodies, from a report; null: all contacts are found. */
  budget: number | null;
  /** Whether the steps between frames are tested, too; see `asksBetween`. */
  between: boolean;
  /** Whether and how characters are tested against themselves. */
  self: SelfChoices;
  /** The frames to be checked, of a report of some frames; null for all. */
  frames: FrameRange | null;

  /** Edits to undo and to redo, the next one last. */
  past: Edit[];
  future: Edit[];

  /** Instances that are not drawn. Their contacts count. */
  hidden: ReadonlySet<number>;
  /** The instance whose card is open, and that the gizmo holds. */
  selected: number | null;
  /** What the handles do; null without handles. */
  gizmo: 'move' | 'turn' | null;
  /** The level of the tree whose boxes are drawn. */
  boxLevel: number | null;
  /** The one that was drawn last. */
  lastBoxLevel: number;
  /** The contacts that are listed. */
  listing: 'frame' | 'clip';
  /** Restricts the listed contacts. */
  filter: Filter;
  /** Whether the numbers of work are shown, and measured. */
  isWorkOpen: boolean;
  /** Whether the filters of contacts of characters with themselves are shown. */
  areSelfFiltersOpen: boolean;
  /** Whether the cards of many characters are shown. */
  areCardsOpen: boolean;
  /** The selected contact; every selection creates a new object. */
  spot: Spot | null;
  /** The side from which the characters are seen at first, once that is known. */
  side: Vector3 | null;
  /** The last movement of the camera. */
  cameraMove: CameraMove | null;
  /** Files are being dragged over the page. */
  isDropping: boolean;
  theme: 'system' | 'dark' | 'light';
  isHelpOpen: boolean;

  /** The worker's last answers, which may be of an earlier frame or scene. */
  answer: AnsweredShot | null;
  costs: MeasuredShot | null;
  sweep: SweepState;
  /** Pictures of the worst frames. */
  stills: Still[];
  /** Place under the pointer. */
  hovered: Surface | null;

  problems: Problem[];
  /** The report, if the page contains one. */
  report: Report | null;
  /** The scene that came with it. */
  reported: Scene | null;
  /** The clips of a report of all clips; `report` is then that of one clip. */
  reel: Reel | null;
  /** Whether the page agrees with the report. */
  finding: Finding | null;
}

/** The state that edits change. */
export const EDITED = ['scene', 'opened', 'arrangement', 'arranged', 'hidden', 'selected'] as const;

export interface Edit {
  before: Pick<State, (typeof EDITED)[number]>;
  /** Null once the edit has ended. */
  subject: string | null;
}

/** Restricts a list of contacts. */
export interface Filter {
  /** Each word must occur in the names of one of the two places. */
  words: string;
  /** Instances that touch, in ascending order; null for all. */
  pair: readonly [number, number] | null;
  /** Standing beside the baseline; null for all. */
  standing: Standing | 'gone' | null;
}

export const NO_FILTER: Filter = { words: '', pair: null, standing: null };

/** Another object each time. The angles, in radians, lead to the right and up. */
export type CameraMove =
  | { kind: 'whole' }
  | { kind: 'turn'; right: number; up: number }
  | { kind: 'zoom'; factor: number };

export interface AnsweredShot extends FrameAnswer {
  shot: Shot;
}

export interface MeasuredShot extends Costs {
  shot: Shot;
  /**
   * Number of frames that the times are a mean of: more than one while the scene plays, because
   * single frames vary much.
   */
  frames: number;
}

export interface SweepState {
  id: number;
  /** Contacts of the frames so far, from the first one; null for frames that are not checked. */
  counts: (number | null)[];
  /** Contacts of bodies with themselves, which are among these. */
  selfCounts: (number | null)[];
  /** Pairs of triangles that the budget has left undecided, as `counts`. */
  undecided: (number | null)[];
  /** The steps so far with contacts between their frames. */
  steps: Step[];
  /** Number of frames that have been searched for a filter, before frames are counted. */
  searched: number;
  total: SweepTotal | null;
}

export interface Still {
  frame: number;
  contacts: number;
  /** Address of an image. */
  picture: string;
}

export interface Problem {
  title: string;
  message: string;
  /** What the user can do about it. */
  remedy?: { label: string; act: () => void } | undefined;
}

export function newSweep(id: number): SweepState {
  const [counts, selfCounts, undecided] = [[], [], []];
  return { id, counts, selfCounts, undecided, steps: [], searched: 0, total: null };
}

export const initialState: State = {
  scene: null,
  opened: null,
  arrangement: 'opened',
  arranged: null,
  characters: [],
  readingOptions: {},
  reading: 'the engine',
  frame: 0,
  moment: null,
  isPlaying: true,
  by: 'instance',
  maxContacts: null,
  lastMaxContacts: 1,
  clearance: null,
  budget: null,
  between: false,
  self: {},
  frames: null,
  past: [],
  future: [],
  hidden: new Set(),
  selected: null,
  gizmo: 'move',
  boxLevel: null,
  lastBoxLevel: 3,
  listing: 'frame',
  filter: NO_FILTER,
  isWorkOpen: false,
  areSelfFiltersOpen: false,
  areCardsOpen: false,
  spot: null,
  side: null,
  cameraMove: null,
  isDropping: false,
  theme: 'system',
  isHelpOpen: false,
  answer: null,
  costs: null,
  sweep: newSweep(0),
  stills: [],
  hovered: null,
  problems: [],
  report: null,
  reported: null,
  reel: null,
  finding: null,
};

export type Change = (state: State) => Partial<State>;
export type Update = (change: Change) => void;
