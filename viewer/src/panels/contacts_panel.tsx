import type { State } from '../state/state';
import type { Shot } from '../worker/protocol';
import type { PanelProps } from './panel_props';
import { Pairs } from './pairs';
import { QuerySwitches } from './query_switches';
import { Stills } from './stills';
import { Touches } from './touches';

export function ContactsPanel({ state, update }: PanelProps) {
  const { answer, sweep, listing } = state;
  const inStep = answer !== null && isInStep(answer.shot, state);
  const isLate = !state.isPlaying && answer?.shot.frame !== state.frame;
  const touches = listing === 'clip' ? sweep.total?.touches : answer?.touches;
  return (
    <section aria-labelledby="contacts">
      <h2 id="contacts">
        Contacts
        <output
          class={`number${answer?.contacts ? ' glowing' : ''}${isLate ? ' late' : ''}`}
          data-fact="contacts"
          data-answered={inStep ? answer.shot.frame : 'earlier'}
        >
          {answer?.contacts.toLocaleString('en') ?? '–'}
        </output>
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
      <Ignored count={listing === 'clip' ? sweep.total?.ignored : answer?.ignored} />
      {listing === 'clip' && <Stills state={state} update={update} />}
      {listing === 'clip' && touches && <Pairs state={state} touches={touches} />}
      {touches ? (
        <Touches touches={touches} state={state} update={update} />
      ) : (
        <p class="quiet">Not counted yet …</p>
      )}
    </section>
  );
}

/** Contacts that the scene says do not count. */
function Ignored({ count }: { count: number | undefined }) {
  if (!count) return null;
  return (
    <p class="quiet">
      <span data-fact="ignored">{count.toLocaleString('en')}</span> ignored
    </p>
  );
}

/** Whether the answer is to the scene as it is now, at whatever frame. */
function isInStep(shot: Shot, { scene, by, firstContact, boxLevel, spot }: State): boolean {
  return (
    shot.scene === scene &&
    shot.by === by &&
    shot.firstContact === firstContact &&
    shot.boxLevel === boxLevel &&
    shot.spot === spot
  );
}
