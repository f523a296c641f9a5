import { worseTouch } from '../report/baseline';
import type { State } from '../state/state';
import type { Touch } from '../worker/protocol';
import { withCommas } from '../words';

/** Shows how a touch is worse than in the baseline: both numbers of contacts. */
export function Worse({ state, touch }: { state: State; touch: Touch }) {
  const found = worseTouch(touch, state);
  if (!found) return null;
  const { worst, known } = found;
  const isNew = known === 0;
  return (
    <small class="worse" title="Contacts in the worst frame, now and in the baseline">
      <b class={isNew ? 'standing new' : 'standing grown'}>{isNew ? 'new' : 'grown'}</b>
      {` ${withCommas(worst.contacts)} in frame ${worst.frame}`}
      {!isNew && `, was ${withCommas(known)}`}
    </small>
  );
}
