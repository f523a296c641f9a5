/** Differences from a baseline. */

import type { Surface, Touch } from '../worker/protocol';
import type { KnownPlace, ReportAnswer, WorseTouch } from './report';
import { isAsItCame, type Asked } from './verdict';

/** Numbers of touches. */
interface Comparison {
  fresh: number;
  grown: number;
  known: number;
  gone: number;
  newlyHeld: number;
}

/** Returns the numbers of the command's summary; null without a baseline. */
export function comparisonOf({ verdict, touches }: ReportAnswer): Comparison | null {
  const { worse, gone, newly_held } = verdict;
  if (!worse) return null;
  const fresh = worse.filter(({ known }) => known === 0).length;
  return {
    fresh,
    grown: worse.length - fresh,
    known: touches.length - worse.length,
    gone: gone?.length ?? 0,
    newlyHeld: newly_held?.length ?? 0,
  };
}

/**
 * Describes a touch that is worse than in the baseline. Returns nothing for other touches, without
 * a baseline, and for another scene than the compared one.
 */
export function worseTouch({ a, b }: Pick<Touch, 'a' | 'b'>, state: Asked): WorseTouch | null {
  const worse = state.report?.answer?.verdict.worse;
  if (!worse || !isAsItCame(state)) return null;
  const found = byPlaces(worse);
  return found.get(`${nameOf(a)}\n${nameOf(b)}`) ?? found.get(`${nameOf(b)}\n${nameOf(a)}`) ?? null;
}

/** Sorts new touches first, then grown ones, then the others. The sort is stable. */
export function worstFirst(touches: readonly Touch[], state: Asked): readonly Touch[] {
  if (!state.report?.answer?.verdict.worse) return touches;
  const rankOf = (touch: Touch) => {
    const worse = worseTouch(touch, state);
    return worse === null ? 2 : worse.known === 0 ? 0 : 1;
  };
  const ranked = touches.map((touch) => ({ touch, rank: rankOf(touch) }));
  return ranked.sort((one, other) => one.rank - other.rank).map(({ touch }) => touch);
}

const known = new WeakMap<readonly WorseTouch[], Map<string, WorseTouch>>();

function byPlaces(worse: readonly WorseTouch[]): Map<string, WorseTouch> {
  const found =
    known.get(worse) ?? new Map(worse.map((one) => [`${nameOf(one.a)}\n${nameOf(one.b)}`, one]));
  known.set(worse, found);
  return found;
}

function nameOf({ instance, part, joint }: KnownPlace | Surface): string {
  return `${instance}\t${part}\t${joint}`;
}
