/** What the page finds beside what the command found, and what has become worse since a baseline. */

import type { State, SweepState } from '../state/state';
import type { FrameRange, Surface, Touch } from '../worker/protocol';
import { stopsAtFirst, type KnownPlace, type ReportAnswer } from './report';

function framesOf([first, end, step]: FrameRange): number[] {
  return Array.from({ length: Math.ceil((end - first) / step) }, (_, i) => first + i * step);
}

export type Finding = 'agrees' | 'differs';

/** Nothing until the page has counted everything, of the scene that came with the report. */
export function findingOf(state: State): Finding | null {
  const answer = state.report?.answer;
  if (!answer || !state.sweep.total || !isAsItCame(state)) return null;
  return isSame(answer, state.sweep) ? 'agrees' : 'differs';
}

function isSame(answer: ReportAnswer, { counts, total }: SweepState): boolean {
  const frames = framesOf(answer.options.frames);
  const sameCounts = answer.counts.every((count, i) => counts[frames[i]] === count);
  return sameCounts && total?.reportHash === answer.hash;
}

/** Whether the page still asks what the command asked, of the scene that came with the report. */
export function isAsItCame({ report, reported, scene, firstContact, by }: State): boolean {
  return (
    report !== null &&
    scene === reported &&
    firstContact === stopsAtFirst(report) &&
    by === report.answer?.options.by
  );
}

export type Standing = 'new' | 'grown' | 'known';

/** What a baseline says of a touch, and how many contacts its worst frame had then; nothing without
 * a baseline. */
export function standingOf(
  { verdict }: ReportAnswer,
  { a, b }: Pick<Touch, 'a' | 'b'>,
): { standing: Standing; then: number } | null {
  if (!verdict.worse) return null;
  const worse = verdict.worse.find(
    (known) => (isAt(known.a, a) && isAt(known.b, b)) || (isAt(known.a, b) && isAt(known.b, a)),
  );
  if (!worse) return { standing: 'known', then: 0 };
  return { standing: worse.known === 0 ? 'new' : 'grown', then: worse.known };
}

function isAt({ instance, part, joint }: KnownPlace, surface: Surface): boolean {
  return instance === surface.instance && part === surface.part && joint === surface.joint;
}
