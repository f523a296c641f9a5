/** The result of the command, and whether the page agrees. */

import { isSameSelf, selfQuestion } from '../scene/self';
import type { Scene } from '../scene/types';
import type { State, SweepState } from '../state/state';
import { counted, withCommas } from '../words';
import type {
  FrameRange,
  SelfQuestion,
  Step,
  Surface,
  SweepTotal,
  Touch,
} from '../worker/protocol';
import {
  asksBetween,
  budgetOf,
  clearanceOf,
  limitOf,
  stepsOf,
  type Finding,
  type KnownPlace,
  type KnownTouch,
  type ReportAnswer,
} from './report';

/** Returns the frames that the command checked; null if these are all frames of the scene. */
export function framesToCheck({ options }: ReportAnswer, scene: Scene | null): FrameRange | null {
  const [first, end, step] = options.frames;
  const isWhole = first === 0 && end === scene?.frameCount && step === 1;
  return isWhole ? null : options.frames;
}

function framesOf([first, end, step]: FrameRange): number[] {
  return Array.from({ length: Math.ceil((end - first) / step) }, (_, i) => first + i * step);
}

/** Returns nothing until the page has counted all frames of the scene in the report. */
export function findingOf(state: State): Finding | null {
  const answer = state.report?.answer;
  if (!answer || !state.sweep.total || !isAsItCame(state)) return null;
  return isSame(answer, state.sweep) ? 'agrees' : 'differs';
}

function isSame(answer: ReportAnswer, sweep: SweepState): boolean {
  const { counts, undecided, steps, total } = sweep;
  const frames = framesOf(answer.options.frames);
  const sameCounts = answer.counts.every((count, i) => counts[frames[i]] === count);
  return (
    sameCounts &&
    total !== null &&
    (answer.hash === null ? hasSameTouches(answer, total) : total.hash === answer.hash) &&
    leavesOutTheSame(answer, total) &&
    hasSameSteps(answer, steps) &&
    hasSameUnknown(answer, undecided)
  );
}

/** For limited contacts and single clips, which have no hash. */
function hasSameTouches({ touches }: ReportAnswer, total: SweepTotal): boolean {
  const [theirs, own] = [contactsByPlaces(touches), contactsByPlaces(total.touches)];
  return theirs.size === own.size && [...theirs].every(([key, count]) => own.get(key) === count);
}

function contactsByPlaces(
  touches: readonly Pick<KnownTouch | Touch, 'a' | 'b' | 'contacts'>[],
): Map<string, number> {
  const counts = new Map<string, number>();
  for (const { a, b, contacts } of touches) {
    const key = [placeName(a), placeName(b)].sort().join('\n');
    counts.set(key, (counts.get(key) ?? 0) + contacts);
  }
  return counts;
}

/** A name for comparison: of parts or joints with equal names, it is the same. */
export function placeName({ instance, part, joint }: KnownPlace | Surface): string {
  return `${instance}\t${part}\t${joint}`;
}

/** Not compared if the command divided steps into pieces, which the page does not. */
function hasSameSteps(answer: ReportAnswer, own: readonly Step[]): boolean {
  const theirs = stepsOf(answer);
  if (!theirs || (answer.options.between?.substeps ?? 1) > 1) return true;
  const key = ({ frame, contacts, first: { to, share, a, b, triangles } }: Step) =>
    [frame, to, contacts, share, a, b, ...triangles].join();
  return theirs.map(key).join('\n') === own.map(key).join('\n');
}

function hasSameUnknown({ totals }: ReportAnswer, undecided: SweepState['undecided']): boolean {
  if (!totals.unknown) return true;
  const { frames, pairs } = totals.unknown;
  const known = undecided.filter((count) => count);
  const most = known.reduce<number>((one, other) => Math.max(one, other ?? 0), 0);
  return known.length === frames && most === pairs;
}

function leavesOutTheSame({ totals }: ReportAnswer, total: SweepTotal): boolean {
  if (!totals.left_out) return true;
  const { rings, at_rest: atRest, always, near_joints: joints } = totals.left_out;
  const { leftOut } = total;
  return (
    rings === leftOut.rings &&
    atRest === leftOut.atRest &&
    always === leftOut.always &&
    joints === leftOut.joints
  );
}

/** Query of the page, and the report that it was opened with. */
export type Asked = Pick<
  State,
  | 'report'
  | 'reported'
  | 'scene'
  | 'maxContacts'
  | 'clearance'
  | 'budget'
  | 'by'
  | 'frames'
  | 'self'
  | 'between'
  | 'characters'
>;

/** Whether scene and query are still those of the report. */
export function isAsItCame(asked: Asked): boolean {
  const { report, reported, scene, maxContacts, clearance, budget, by, frames, between } = asked;
  return (
    report !== null &&
    scene === reported &&
    (!report.answer || frames === framesToCheck(report.answer, scene)) &&
    maxContacts === limitOf(report) &&
    clearance === clearanceOf(report) &&
    budget === budgetOf(report) &&
    by === report.answer?.options.by &&
    between === asksBetween(report) &&
    asksSelfAsReported(asked, report.answer)
  );
}

function asksSelfAsReported({ scene, by, characters, self }: Asked, { options }: ReportAnswer) {
  if (!scene) return false;
  return isSameSelf(selfQuestion({ scene, by, characters, self }, null), reportedSelf(options));
}

/** What the command asked, as the page asks it; without frames. */
function reportedSelf({ self }: ReportAnswer['options']): SelfQuestion | null {
  if (!self) return null;
  return {
    isOnly: self.only,
    rings: self.rings,
    dropsAtRest: self.at_rest === 'drop',
    always: self.always === 'keep' ? null : self.always,
    dropsNearJoints: self.near_joints === 'drop',
    frames: null,
  };
}

/** The report in five words. */
export function headlineOf({ totals, options, verdict }: ReportAnswer): string {
  if (verdict.pairs_compared === 0) return 'Nothing was compared';
  const { frames, frames_in_contact: inContact } = totals;
  const which = inContact === 0 ? `No contact${totals.unknown?.frames ? ' known' : ''}` : 'Contact';
  const rest = unknownInWords(totals);
  if (frames === 1) return `${which} in frame ${options.frames[0]}${rest}`;
  if (inContact === 0) return `${which} in ${counted(frames, 'frame')}${rest}`;
  return `${which} in ${withCommas(inContact)} of ${counted(frames, 'frame')}${rest}`;
}

/** With --budget: how many frames may have more contacts. */
function unknownInWords({ frames, unknown }: ReportAnswer['totals']): string {
  if (!unknown || unknown.frames === 0) return '';
  return frames === 1 ? ', not decided' : `, ${withCommas(unknown.frames)} not decided`;
}

/** The first frame with the most contacts; nothing where none has any. */
export function worstFrame({
  counts,
  options,
}: Pick<ReportAnswer, 'counts' | 'options'>): { frame: number; contacts: number } | null {
  const contacts = counts.reduce((one, other) => Math.max(one, other), 0);
  if (contacts === 0) return null;
  return { frame: framesOf(options.frames)[counts.indexOf(contacts)], contacts };
}
