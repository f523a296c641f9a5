/** The steps between frames: whether they are tested, and those with contacts. */

import { stepsOf, type ReportAnswer } from '../report/report';
import { isAsItCame } from '../report/verdict';
import type { Step } from '../worker/protocol';
import type { State } from './state';

/** Returns why the steps cannot be tested, or null if they can be. */
export function whyNotBetween({
  maxContacts,
  clearance,
  budget,
}: Pick<State, 'maxContacts' | 'clearance' | 'budget'>): string | null {
  if (clearance !== null) return 'Not available for distances';
  if (budget !== null) return 'Not available with a budget';
  if (maxContacts !== null) return 'Not available with a limit';
  return null;
}

export function asksBetween(
  state: Pick<State, 'between' | 'maxContacts' | 'clearance' | 'budget'>,
): boolean {
  return state.between && whyNotBetween(state) === null;
}

/**
 * Returns the steps with contacts between their frames, as far as they are known; null if they are not
 * tested. Those of an unchanged report are those of the command.
 */
export function knownSteps(state: State): readonly Step[] | null {
  if (!asksBetween(state)) return null;
  const answer = unchangedAnswer(state);
  return answer ? stepsOf(answer) : state.sweep.steps;
}

/** The hash of these contacts; null if it is not known. */
export function betweenHash(state: State): string | null {
  const answer = unchangedAnswer(state);
  return (answer ? answer.totals.between?.hash : state.sweep.total?.betweenHash) ?? null;
}

/** The answer of the command to the query of the page; null without one. */
function unchangedAnswer(state: State): ReportAnswer | null {
  return state.report?.answer && isAsItCame(state) ? state.report.answer : null;
}
