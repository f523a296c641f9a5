/** Steps with contacts between their frames, which `pelt check --between` has found. */

import type { ReportAnswer, ReportedStep } from '../report/report';
import { pauseBetween } from '../state/changes';
import type { Moment } from '../worker/protocol';
import { counted, withCommas } from '../words';
import type { PanelProps } from './panel_props';

const MOST_LISTED = 8;

interface BetweenProps {
  answer: ReportAnswer;
  update: PanelProps['update'];
}

/** Lists the steps with the most contacts first. The page does not count them itself. */
export function Between({ answer: { steps, verdict }, update }: BetweenProps) {
  if (!steps) return null;
  if (steps.length === 0) return <p class="quiet">Nothing touches between frames only.</p>;
  const worse = verdict.between?.worse.length ?? 0;
  const listed = worstSteps(steps).slice(0, MOST_LISTED);
  return (
    <>
      <p class="between-frames">
        {betweenInWords(steps)}
        {worse > 0 && <b>, {withCommas(worse)} new or grown</b>}
      </p>
      <ul class="steps">
        {listed.map((one) => (
          <li>
            <button
              class="link"
              title="Go to the first time of contact"
              onClick={() => update(pauseBetween(one.step, momentOfStep(one)))}
            >
              from frame {one.step} to {one.to}
            </button>
            : {counted(one.only_between, 'contact')}, first at {one.first.toFixed(4)} s
          </li>
        ))}
        {steps.length > listed.length && (
          <li class="quiet">and {counted(steps.length - listed.length, 'more step')}</li>
        )}
      </ul>
    </>
  );
}

function momentOfStep({ of_self: isOfSelf, first: seconds, ...step }: ReportedStep): Moment {
  const { to, share, a, b, triangles } = step;
  return { to, share, seconds, a, b, triangles, isOfSelf };
}

/** Returns the steps with the most contacts first; of equal ones, the earliest. */
export function worstSteps(steps: readonly ReportedStep[]): ReportedStep[] {
  return [...steps].sort((x, y) => y.only_between - x.only_between || x.step - y.step);
}

export function betweenInWords(steps: readonly ReportedStep[]): string {
  const contacts = steps.reduce((sum, { only_between: count }) => sum + count, 0);
  return `${counted(contacts, 'contact')} between frames only, in ${counted(steps.length, 'step')}`;
}
