import { checkAllFrames } from '../state/changes';
import { totalsOf } from '../state/counts';
import { rearrange } from '../state/edits';
import { checkedFrames, rangeInWords } from '../state/frames';
import { filtered, listedTouches } from '../state/listing';
import { isLate } from '../state/shots';
import type { State } from '../state/state';
import { withCommas } from '../words';
import { Filters } from './filters';
import { Gone } from './gone';
import type { PanelProps } from './panel_props';
import { Pairs } from './pairs';
import { QuerySwitches } from './query_switches';
import { SameNumbers } from './same_numbers';
import { Stills } from './stills';
import { Touches } from './touches';

/** The question, and one list of contacts for each kind of answer. */
export function ContactsPanel({ state, update }: PanelProps) {
  const { answer, sweep, listing } = state;
  return (
    <section class="contacts" aria-labelledby="contacts">
      <h2>
        <span id="contacts">Contacts</span>
        <Count state={state} />
      </h2>
      <div class="row">
        <div class="choice" role="group" aria-label="Listed contacts">
          {(['frame', 'clip'] as const).map((choice) => (
            <button
              aria-pressed={listing === choice}
              onClick={() => update(() => ({ listing: choice }))}
            >
              {choice === 'frame' ? 'this frame' : 'whole clip'}
            </button>
          ))}
        </div>
      </div>
      <QuerySwitches state={state} update={update} />
      <Checked state={state} update={update} />
      <Ignored count={listing === 'clip' ? sweep.total?.ignored : answer?.ignored} />
      <SameNumbers state={state} />
      <Stills state={state} update={update} />
      <BetweenCharacters state={state} update={update} />
    </section>
  );
}

/** Contacts of different instances or parts. */
function BetweenCharacters({ state, update }: PanelProps) {
  const { filter, report } = state;
  const touches = listedTouches(state);
  if (!touches) return <p class="nothing quiet">Not counted yet …</p>;
  if (touches.length === 0 && filter.standing !== 'gone') {
    return <Nothing state={state} update={update} />;
  }
  return (
    <>
      {state.listing === 'clip' && <Pairs state={state} touches={touches} update={update} />}
      <Filters state={state} update={update} />
      {filter.standing === 'gone' ? (
        <Gone gone={report?.answer?.verdict.gone ?? []} words={filter.words} />
      ) : (
        <Touches touches={filtered(touches, state)} state={state} update={update} />
      )}
    </>
  );
}

/** Says that nothing touches, and how characters meet that walk past each other. */
function Nothing({ state, update }: PanelProps) {
  const { sweep, arrangement, scene } = state;
  const isNever = sweep.total !== null && totalsOf(sweep.counts).contacts === 0;
  const walksPast = isNever && arrangement === 'walking' && scene!.instances.length > 1;
  return (
    <div class="nothing quiet">
      <p>{isNever ? 'Nothing touches in any frame.' : 'Nothing touches.'}</p>
      {walksPast && (
        <button class="link" onClick={() => update(rearrange('together'))}>
          Put all in the same place
        </button>
      )}
    </div>
  );
}

/** Says which frames count, if not all do. */
function Checked({ state, update }: PanelProps) {
  const range = checkedFrames(state);
  if (!range) return null;
  return (
    <p class="quiet checked">
      Checked: frames {rangeInWords(range)}, of 0 to {state.scene!.frameCount - 1}.{' '}
      <button class="link" onClick={() => update(checkAllFrames)}>
        Check all frames
      </button>
    </p>
  );
}

/** Number of listed contacts. */
function Count({ state }: { state: State }) {
  const { answer, sweep, listing } = state;
  const ofClip = sweep.total && totalsOf(sweep.counts).contacts;
  const count = listing === 'clip' ? ofClip : answer?.contacts;
  const classes = [
    'number',
    ...(count ? ['glowing'] : []),
    ...(listing === 'frame' && isLate(state) ? ['late'] : []),
  ];
  return (
    <span class={classes.join(' ')} data-fact="listed">
      {count === undefined || count === null ? '–' : withCommas(count)}
    </span>
  );
}

/** Contacts that the scene says do not count. */
function Ignored({ count }: { count: number | undefined }) {
  if (!count) return null;
  return (
    <p class="quiet">
      <span data-fact="ignored">{withCommas(count)}</span> ignored
    </p>
  );
}
