/** Numbers beside the timeline: of the frame, and of all of them. */

import { frameTime } from '../scene/scene';
import { totalsOf } from '../state/counts';
import { checkedFrames, isInRange } from '../state/frames';
import { isInStep, isLate, momentOf } from '../state/shots';
import type { State, SweepState } from '../state/state';
import { knownSteps } from '../state/steps';
import { counted, withCommas } from '../words';
import { memo } from './memo';

export function FrameFacts({ state, frame }: { state: State; frame: number }) {
  const { scene, answer } = state;
  const count = scene!.frameCount;
  const moment = momentOf(state);
  const step = knownSteps(state)?.find((one) => one.frame === frame);
  return (
    <p>
      <span>
        frame <b data-fact="frame">{frame}</b>
        <small>
          {moment && ` to ${moment.to}: first contact between them`}
          {!moment && (count > 1 ? ` of 0–${count - 1}` : ', the only one')} ·{' '}
          {moment ? moment.seconds.toFixed(4) : frameTime(scene!, frame).toFixed(3)} s ·{' '}
        </small>
      </span>
      <span
        class={isLate(state) ? 'late' : ''}
        data-answered={isInStep(state) ? answer!.shot.frame : 'earlier'}
      >
        <b data-fact="contacts">{answer ? withCommas(answer.contacts) : '–'}</b>
        <small>
          {answer?.contacts === 1 ? ' contact' : ' contacts'}
          {!isInRange(frame, checkedFrames(state)) && ', not checked'}
          {!!answer?.undecided && `, ${counted(answer.undecided, 'pair')} of triangles not decided`}
          {step && !moment && `, ${withCommas(step.contacts)} more before frame ${step.first.to}`}
        </small>
      </span>
    </p>
  );
}

/** For screen readers. While the scene plays, it would be too much to follow. */
export function Announcement({ state, frame }: { state: State; frame: number }) {
  const { answer, isPlaying } = state;
  const isKnown = !isPlaying && isInStep(state) && answer!.shot.frame === frame;
  return (
    <p class="unseen" role="status">
      {isKnown && `frame ${frame}: ${counted(answer!.contacts, 'contact')}`}
    </p>
  );
}

interface SweepFactsProps {
  sweep: SweepState;
  frameCount: number;
  /** Whether the query compares anything. */
  compares: boolean;
}

export const SweepFacts = memo(({ sweep, frameCount, compares }: SweepFactsProps) => {
  const { counts, undecided, searched, total } = sweep;
  const percentOf = (frames: number) => `${Math.floor((100 * frames) / frameCount)} %`;
  if (!total && searched > 0 && counts.length === 0) {
    return <small>looking for what always touches {percentOf(searched)}</small>;
  }
  if (!total) return <small>counting {percentOf(counts.length)}</small>;
  const { contacts, inContact, checked } = totalsOf(counts);
  const notDecided = undecided.filter((count) => count).length;
  return (
    <small title="The same numbers as in `pelt check`">
      <span data-fact="total">{withCommas(contacts)}</span>
      {contacts === 1 ? ' contact' : ' contacts'} in{' '}
      {frameCount > 1 && `${withCommas(inContact)} of `}
      {counted(checked, checked === frameCount ? 'frame' : 'checked frame')}
      {notDecided > 0 && ` · ${withCommas(notDecided)} not decided`}
      {!compares && ' · nothing was compared'}
      {total.hash && (
        <>
          {' · '}
          <code data-fact="hash">{total.hash}</code>
        </>
      )}
    </small>
  );
});
