import { checkAllFrames } from '../state/changes';
import { totalsOf } from '../state/counts';
import { checkedFrames, rangeInWords } from '../state/frames';
import { isLate } from '../state/shots';
import type { State } from '../state/state';
import { withCommas } from '../words';
import type { PanelProps } from './panel_props';
import { Pairs } from './pairs';
import { QuerySwitches } from './query_switches';
import { SameNumbers } from './same_numbers';
import { Stills } from './stills';
import { Touches } from './touches';

export function ContactsPanel({ state, update }: PanelProps) {
  const { answer, sweep, listing } = state;
  const touches = listing === 'clip' ? sweep.total?.touches : answer?.touches;
  return (
    <section class="contacts" aria-labelledby="contacts">
      <h2 id="contacts">
        Contacts
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
        <QuerySwitches state={state} update={update} />
      </div>
      <Checked state={state} update={update} />
      <Ignored count={listing === 'clip' ? sweep.total?.ignored : answer?.ignored} />
      <Stills state={state} update={update} />
      {listing === 'clip' && touches && <Pairs state={state} touches={touches} />}
      {touches ? (
        <Touches touches={touches} state={state} update={update} />
      ) : (
        <p class="nothing quiet">Not counted yet …</p>
      )}
      <SameNumbers state={state} />
    </section>
  );
}

/** Says which frames count, if not all do. */
function Checked({ state, update }: PanelProps) {
  const range = checkedFrames(state);
  if (!range) return null;
  return (
    <p class="quiet checked">
      Checked: frames {rangeInWords(range)} of 0 to {state.scene!.frameCount - 1}.{' '}
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
    <output class={classes.join(' ')} data-fact="listed">
      {count === undefined || count === null ? '–' : withCommas(count)}
    </output>
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
