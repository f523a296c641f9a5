/** Steps with contacts between their frames. */

import { pauseBetween } from '../state/changes';
import { momentOf } from '../state/shots';
import type { State } from '../state/state';
import { betweenHash, knownSteps } from '../state/steps';
import type { Step } from '../worker/protocol';
import { counted, withCommas } from '../words';
import { useFew } from './few';
import type { PanelProps } from './panel_props';

const FEW = 8;

/** Lists the steps with the most contacts first; each leads to its first time of contact. */
export function BetweenFrames({ state, update }: PanelProps) {
  const steps = knownSteps(state);
  const { shown, more } = useFew(worstSteps(steps ?? []), FEW);
  if (!steps) return null;
  const at = momentOf(state);
  return (
    <div class="between" role="group" aria-labelledby="between-frames">
      <h3>
        <i class="dot of-steps" />
        <span id="between-frames">Only between frames</span>
        <span class="count" data-fact="between">
          {withCommas(contactsOf(steps))}
        </span>
      </h3>
      <p class="quiet">{explanation(state, steps)}</p>
      <ul class="steps">
        {shown.map((step) => (
          <Row
            step={step}
            isCurrent={at?.to === step.first.to && state.frame === step.frame}
            update={update}
          />
        ))}
      </ul>
      {more}
      {steps.length > 0 && <Hash hash={betweenHash(state)} />}
    </div>
  );
}

interface RowProps {
  step: Step;
  /** Whether the page stands at its first time of contact. */
  isCurrent: boolean;
  update: PanelProps['update'];
}

function Row({ step: { frame, contacts, first }, isCurrent, update }: RowProps) {
  return (
    <li>
      <button
        class="touch"
        aria-pressed={isCurrent}
        title="Go to the first time of contact"
        onClick={() => update(pauseBetween(frame, first))}
      >
        <span>
          frames {frame}–{first.to}
        </span>
        <span class="quiet">first at {first.seconds.toFixed(4)} s</span>
        <span class="count">{withCommas(contacts)}</span>
      </button>
    </li>
  );
}

function explanation({ sweep }: State, steps: readonly Step[]): string {
  if (steps.length > 0) {
    const where = counted(steps.length, 'step');
    return `Triangles that touch on the way from one frame to the next, but in neither, in ${where}:`;
  }
  return sweep.total ? 'Nothing touches between frames only.' : 'Not counted yet …';
}

/** As `pelt check --between` prints it. */
function Hash({ hash }: { hash: string | null }) {
  if (!hash) return null;
  return (
    <p class="quiet">
      hash between frames <code data-fact="between-hash">{hash}</code>
    </p>
  );
}

/** Returns the steps with the most contacts first; of equal ones, the earliest. */
export function worstSteps(steps: readonly Step[]): Step[] {
  return [...steps].sort((x, y) => y.contacts - x.contacts || x.frame - y.frame);
}

function contactsOf(steps: readonly Step[]): number {
  return steps.reduce((sum, { contacts }) => sum + contacts, 0);
}

export function betweenInWords(steps: readonly Step[]): string {
  if (steps.length === 0) return 'Nothing touches between frames only.';
  const [contacts, where] = [counted(contactsOf(steps), 'contact'), counted(steps.length, 'step')];
  return `${contacts} between frames only, in ${where}`;
}
