/** Data in the page from `pelt check --html` and `pelt view`. README.md describes the format. */

import type { NamePair } from 'pelt';
import type { By, FrameRange, ReadingOptions, Step } from '../worker/protocol';

/** Version of the engine in the page. */
const PELT_VERSION: string = import.meta.env.VITE_PELT_VERSION;

export interface Report {
  format: 'pelt-report';
  version: 1;
  /** Version of the command. */
  pelt: string;
  /** Time of the check: "2026-11-22T14:05:09Z". */
  made: string;
  /** The words by which it was made. */
  command: string;
  /** Title of the scene: the name of its file, or the names of its models. */
  title: string;
  /** Path in `files`. */
  scene: string;
  /** Base64, by paths. */
  files: Record<string, string>;
  inputs: ReportInput[];
  reading: ReadingOptions;
  /** Clips that are played one after the other, if instances play all clips. */
  clips?: ReportedTake[] | null;
  /** Null from `pelt view`, which runs no query. */
  answer: ReportAnswer | null;
}

/** Frames in which all instances that play all clips play this clip. */
export interface ReportedTake {
  clip: string;
  first_frame: number;
  frames: number;
}

/** A character's file, for people. */
export interface ReportInput {
  /** Path as given, or the options that the character was generated with. */
  path: string;
  /** Path in `files`; null if generated. */
  file: string | null;
  bytes: number | null;
  hash: string;
}

/** Names and meaning as in `pelt check --jsonl`. */
export interface ReportAnswer {
  options: {
    method: string;
    by: By;
    /** First, end, step. */
    frames: FrameRange;
    max_contacts: number | null;
    /** Null: triangles have to touch. */
    clearance: number | null;
    /** Units of work for each pair and frame; absent without --budget. */
    budget?: number;
    /** Null or absent: no body was tested against itself. */
    self?: ReportedSelf | null;
    /** Absent without --between. Straight pieces of each step. */
    between?: { substeps: number };
    ignore: NamePair[];
  };
  /** Contacts of each of these frames. */
  counts: number[];
  /** Steps with contacts between their frames; null or absent without --between. */
  steps?: ReportedStep[] | null;
  totals: {
    frames: number;
    frames_in_contact: number;
    contacts: number;
    /** 0 for one clip of a report of all clips. */
    ignored: number;
    /** Contacts of bodies with themselves that filters have left out, if they were tested. */
    left_out?: Record<'rings' | 'at_rest' | 'always' | 'near_joints', number>;
    /** With --budget: frames with undecided pairs of triangles, and the most pairs of one frame. */
    unknown?: { frames: number; pairs: number };
    /** With --between, but not for one clip of a report of all clips. */
    between?: { hash: string };
  };
  /** Null if contacts were limited, and for one clip of a report of all clips. */
  hash: string | null;
  touches: KnownTouch[];
  /** Bodies wholly inside others, with --inside. */
  held?: HeldBody[];
  verdict: {
    fail_on: string;
    failed: boolean;
    /** Pairs of colliders that each frame compares; 0: nothing was checked. */
    pairs_compared: number;
    /** Null without a baseline, like the members below. */
    worse: WorseTouch[] | null;
    /** Touches of the baseline that this check did not find. */
    gone: GoneTouch[] | null;
    /** Bodies that another one holds whole, with --inside. */
    newly_held: { clip?: string }[] | null;
    /** The same for contacts between frames, with --between and a baseline. */
    between?: { worse: { clip?: string }[] };
    /** Differences of the earlier check from this one. */
    notes: string[] | null;
  };
}

/** A step in which triangles touch that touch in neither of its frames. */
export interface ReportedStep {
  /** The frame in which the step begins, and the one in which it ends. */
  step: number;
  to: number;
  /** Contacts that touch in neither frame. */
  only_between: number;
  /** Seconds from the start of the clip to the first of these contacts. */
  first: number;
  /** The share of the step that has passed then. */
  share: number;
  /** Instances and triangles of this contact, and whether a body touches itself. */
  a: number;
  b: number;
  triangles: [number, number];
  of_self: boolean;
}

/** Options of tests of bodies against themselves. */
export interface ReportedSelf {
  only: boolean;
  rings: number;
  at_rest: 'keep' | 'drop';
  always: 'keep' | number;
  near_joints: 'keep' | 'drop';
}

export interface KnownTouch {
  /** Only in reports of all clips, like other `clip` members. */
  clip?: string;
  a: KnownPlace;
  b: KnownPlace;
  contacts: number;
  worst: { frame: number; contacts: number };
}

export interface WorseTouch extends KnownTouch {
  /** Contacts of its worst frame in the baseline; 0: it is new. */
  known: number;
}

/** A name that does not depend on numbers of instances. */
export interface KnownName {
  model: string;
  /** Index among the instances of the model. */
  copy: number;
  part?: string;
  joint: string;
}

export interface KnownPlace extends KnownName {
  instance: number;
  part: string;
}

export interface GoneTouch {
  clip?: string;
  a: KnownName;
  b: KnownName;
  /** Contacts of its worst frame in the baseline. */
  known: number;
}

export interface HeldBody {
  clip?: string;
  inner: Body;
  outer: Body;
  /** Number of frames, and the first of them. */
  frames: number;
  first_frame: number;
}

/** An instance, or a part of one. */
interface Body {
  instance: number;
  model: string;
  part?: string;
}

/** One clip of a report of all clips. */
export interface ClipReport {
  clip: string;
  frameCount: number;
  /** The report of this clip alone, without files. */
  report: Report;
  /** Most contacts of a frame, and frames in contact; null without an answer. */
  worst: number | null;
  framesInContact: number | null;
}

/** A report of all clips, and what its scene plays. */
export interface Reel {
  /** In the order of the report, without clips that were not checked. */
  clips: readonly ClipReport[];
  /** The instances that play all clips. */
  players: readonly number[];
}

/** How a touch stands beside the baseline. */
export type Standing = 'new' | 'grown' | 'known';

/** Whether the page finds what the command has found. */
export type Finding = 'agrees' | 'differs';

/**
 * Returns nothing if the page is not a report. Throws an error for a report that the page cannot
 * show.
 */
export function findReport(page: Document): Report | null {
  const text = page.getElementById('pelt-data')?.textContent?.trim();
  if (!text) return null;
  const data = parse(text);
  if (data.format !== 'pelt-report' || data.version !== 1) {
    throw new Error(
      'The data in this page is not a report: write it again with `pelt check --html`.',
    );
  }
  if (data.pelt !== PELT_VERSION) {
    throw new Error(
      `The data was written by Pelt ${data.pelt}, the page by ${PELT_VERSION}: write the report ` +
        'again with one version.',
    );
  }
  return data as Report;
}

function parse(text: string): Partial<Report> {
  try {
    return JSON.parse(text);
  } catch {
    throw new Error('The data in this page is truncated or damaged: get the file again.');
  }
}

/** Most contacts of each pair; null for all. */
export function limitOf({ answer }: Report): number | null {
  return answer ? answer.options.max_contacts : null;
}

/** Whether the command tested the steps between frames. */
export function asksBetween({ answer }: Report): boolean {
  return answer !== null && stepsOf(answer) !== null;
}

/** The steps with contacts between their frames; null if the command did not test steps. */
export function stepsOf({ steps }: ReportAnswer): Step[] | null {
  return steps?.map(stepOf) ?? null;
}

function stepOf(reported: ReportedStep): Step {
  const { step: frame, only_between: contacts, first: seconds, of_self: isOfSelf } = reported;
  const { to, share, a, b, triangles } = reported;
  return { frame, contacts, first: { to, share, seconds, a, b, triangles, isOfSelf } };
}

/** Largest distance of two triangles in contact; null if they have to touch. */
export function clearanceOf({ answer }: Report): number | null {
  return answer ? answer.options.clearance : null;
}

/** Units of work for each pair of bodies in a frame; null without a limit. */
export function budgetOf({ answer }: Report): number | null {
  return answer?.options.budget ?? null;
}

/** Returns the original path of a file of the report. */
export function originalPath({ inputs }: Report, file: string): string {
  return inputs.find((input) => input.file === file)?.path ?? file;
}

/** Returns the file of `--baseline`, as in the command line. */
export function baselineOf({ command }: Report): string {
  const [, file = 'the baseline'] = command.match(/--baseline[ =]('[^']*'|\S+)/) ?? [];
  return file;
}
