/** Differences from a baseline. */

import type { Touch } from '../worker/protocol';
import type { ReportAnswer, Standing, WorseTouch } from './report';
import { isAsItCame, placeName, type Asked } from './verdict';

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
  const worse = comparedAnswer(state)?.verdict.worse;
  if (!worse) return null;
  const found = byPlaces(worse);
  return (
    found.get(`${placeName(a)}\n${placeName(b)}`) ??
    found.get(`${placeName(b)}\n${placeName(a)}`) ??
    null
  );
}

/** Returns null without a baseline, and for another scene than the compared one. */
export function standingOf(touch: Pick<Touch, 'a' | 'b'>, state: Asked): Standing | null {
  if (!comparedAnswer(state)) return null;
  const worse = worseTouch(touch, state);
  return worse === null ? 'known' : worse.known === 0 ? 'new' : 'grown';
}

/** The answer of a report that was compared with a baseline, if it is of this scene and query. */
export function comparedAnswer(state: Asked): ReportAnswer | null {
  const answer = state.report?.answer;
  return answer?.verdict.worse && isAsItCame(state) ? answer : null;
}

/** Sorts new touches first, then grown ones, then the others. The sort is stable. */
export function worstFirst(touches: readonly Touch[], state: Asked): readonly Touch[] {
  if (!state.report?.answer?.verdict.worse) return touches;
  const rankOf = (touch: Touch) => RANKS[standingOf(touch, state) ?? 'known'];
  const ranked = touches.map((touch) => ({ touch, rank: rankOf(touch) }));
  return ranked.sort((one, other) => one.rank - other.rank).map(({ touch }) => touch);
}

const RANKS = { new: 0, grown: 1, known: 2 };

const known = new WeakMap<readonly WorseTouch[], Map<string, WorseTouch>>();

function byPlaces(worse: readonly WorseTouch[]): Map<string, WorseTouch> {
  const found =
    known.get(worse) ??
    new Map(worse.map((one) => [`${placeName(one.a)}\n${placeName(one.b)}`, one]));
  known.set(worse, found);
  return found;
}
