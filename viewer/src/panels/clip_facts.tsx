/** Numbers beside the timeline: of the frame, and of all of them. */

import { frameTime } from '../scene/scene';
import { isInStep, isLate } from '../state/shots';
import type { State, SweepState } from '../state/state';
import { counted, withCommas } from '../words';
import { memo } from './memo';

export function FrameFacts({ state, frame }: { state: State; frame: number }) {
  const { scene, answer } = state;
  const count = scene!.frameCount;
  return (
    <p>
      <output>
        frame <b data-fact="frame">{frame}</b>
        <small>
          {count > 1 ? ` of 0–${count - 1}` : ', the only one'} ·{' '}
          {frameTime(scene!, frame).toFixed(3)} s ·{' '}
        </small>
      </output>
      <output
        class={isLate(state) ? 'late' : ''}
        data-answered={isInStep(state) ? answer!.shot.frame : 'earlier'}
      >
        <b data-fact="contacts">{answer ? withCommas(answer.contacts) : '–'}</b>
        <small>{answer?.contacts === 1 ? ' contact' : ' contacts'}</small>
      </output>
    </p>
  );
}

interface SweepFactsProps {
  sweep: SweepState;
  frameCount: number;
}

export const SweepFacts = memo(({ sweep, frameCount }: SweepFactsProps) => {
  const { counts, total } = sweep;
  if (!total) {
    return <small>counting {Math.floor((100 * counts.length) / frameCount)} %</small>;
  }
  const contacts = counts.reduce((sum, count) => sum + count, 0);
  const touched = counts.filter((count) => count > 0).length;
  return (
    <small title="The same numbers as in `pelt check`">
      <span data-fact="total">{withCommas(contacts)}</span>
      {contacts === 1 ? ' contact' : ' contacts'} in {counted(touched, 'frame')}
      {total.hash && (
        <>
          {' · '}
          <code data-fact="hash">{total.hash}</code>
        </>
      )}
    </small>
  );
});
