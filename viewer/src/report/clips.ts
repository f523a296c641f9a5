/** A report of all clips, as reports of single clips. The page shows one clip at a time. */

import type { Scene } from '../scene/types';
import type { FrameRange } from '../worker/protocol';
import type { ClipReport, Reel, Report, ReportAnswer, ReportedStep, ReportedTake } from './report';
import { worstFrame } from './verdict';

/** Returns null for a report of another kind. */
export function reelOf(report: Report): Reel | null {
  if (!report.clips) return null;
  const clips = report.clips.flatMap((take) => clipReport(report, take) ?? []);
  const { instances } = sceneFileOf(report);
  const players = [...instances.keys()].filter((i) => instances[i].clip === ALL_CLIPS);
  return { clips, players };
}

/** The clip with the most contacts in one frame; of equal ones, the first. */
export function worstClip({ clips }: Reel): ClipReport {
  return clips.reduce((one, other) => ((other.worst ?? 0) > (one.worst ?? 0) ? other : one));
}

/** The files of a report, with a scene that plays one clip only. */
export function filesWithClip(report: Report, { clip, frameCount }: ClipReport): Report['files'] {
  const file = sceneFileOf(report);
  const instances = file.instances.map((one) => (one.clip === ALL_CLIPS ? { ...one, clip } : one));
  const frames = { ...file.frames, count: frameCount };
  return { ...report.files, [report.scene]: encode({ ...file, frames, instances }) };
}

/** The scene of one clip, made from that of another one. */
export function sceneOfClip(
  scene: Scene,
  { clip, frameCount, report }: ClipReport,
  { players }: Reel,
): Scene {
  const instances = scene.instances.map((one, i) => (players.includes(i) ? { ...one, clip } : one));
  return { ...scene, name: report.title, frameCount, instances };
}

/** Clip of an instance that plays all clips of its character. */
const ALL_CLIPS = '*';

/** The scene file, as far as the page changes it. */
interface SceneFile {
  frames?: Record<string, unknown>;
  instances: { clip?: string | null }[];
}

function sceneFileOf({ files, scene }: Report): SceneFile {
  const bytes = Uint8Array.from(atob(files[scene]), (letter) => letter.charCodeAt(0));
  return JSON.parse(new TextDecoder().decode(bytes));
}

/** Base64 of the JSON in UTF-8. */
function encode(file: SceneFile): string {
  const bytes = new TextEncoder().encode(JSON.stringify(file));
  return btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(''));
}

/** Returns null if no frame of the clip was checked. */
function clipReport(report: Report, take: ReportedTake): ClipReport | null {
  const { clip, frames: frameCount } = take;
  const answer = report.answer && answerOfTake(report.answer, take);
  if (report.answer && !answer) return null;
  return {
    clip,
    frameCount,
    report: { ...report, files: {}, title: `${report.title}, clip ${clip || 'unnamed'}`, answer },
    worst: answer && (worstFrame(answer)?.contacts ?? 0),
    framesInContact: answer && answer.totals.frames_in_contact,
  };
}

/** Frames count from the start of the clip. Hash and dropped contacts are only known of all clips. */
function answerOfTake(answer: ReportAnswer, take: ReportedTake): ReportAnswer | null {
  const { frames, begin } = checkedFramesOf(take, answer.options.frames);
  const [first, end, step] = frames;
  if (first >= end) return null;
  const counts = answer.counts.slice(begin, begin + Math.ceil((end - first) / step));
  const contacts = counts.reduce((sum, count) => sum + count, 0);
  const inContact = counts.filter((count) => count > 0).length;
  const { verdict } = answer;
  const ofClip = <T extends OfClip>(list: readonly T[] | null) =>
    list && list.filter(({ clip }) => clip === take.clip).map(countedInClip);
  return {
    ...answer,
    options: { ...answer.options, frames },
    counts,
    ...(answer.steps && { steps: stepsOfTake(answer.steps, take) }),
    totals: { frames: counts.length, frames_in_contact: inContact, contacts, ignored: 0 },
    hash: null,
    touches: ofClip(answer.touches)!,
    ...(answer.held && { held: ofClip(answer.held)! }),
    verdict: {
      ...verdict,
      worse: ofClip(verdict.worse),
      gone: ofClip(verdict.gone),
      newly_held: ofClip(verdict.newly_held),
      ...(verdict.between && { between: { worse: ofClip(verdict.between.worse)! } }),
    },
  };
}

/** Returns the steps of the clip, counted from its start. */
function stepsOfTake(
  steps: readonly ReportedStep[],
  { first_frame: start, frames: count }: ReportedTake,
): ReportedStep[] {
  return steps
    .filter(({ step }) => step >= start && step < start + count)
    .map((one) => ({ ...one, step: one.step - start, to: one.to - start }));
}

/** Returns the checked frames, counted from the start of the clip, and the index of the first. */
function checkedFramesOf(
  { first_frame: start, frames: count }: ReportedTake,
  [first, end, step]: FrameRange,
): { frames: FrameRange; begin: number } {
  const begin = Math.max(0, Math.ceil((start - first) / step));
  const frames: FrameRange = [first + begin * step - start, Math.min(end - start, count), step];
  return { frames, begin };
}

/** Members of lists of a report of all clips. */
interface OfClip {
  clip?: string;
  worst?: { frame: number; clip_frame?: number; contacts: number };
  first_frame?: number;
  first_clip_frame?: number;
}

function countedInClip<T extends OfClip>(one: T): T {
  const { worst, first_clip_frame: first } = one;
  return {
    ...one,
    ...(worst && { worst: { ...worst, frame: worst.clip_frame ?? worst.frame } }),
    ...(first !== undefined && { first_frame: first }),
  };
}
