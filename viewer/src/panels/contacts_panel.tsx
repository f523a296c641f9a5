import { bodyColour, cssColour } from '../draw/colours';
import { toggleFirstContact } from '../state/changes';
import type { State } from '../state/state';
import type { Shot, Surface, Touch } from '../worker/protocol';
import type { PanelProps } from './app';
import { Pairs } from './pairs';
import { Stills } from './stills';

const MOST_ROWS = 6;

export function ContactsPanel({ state, update }: PanelProps) {
  const { answer, firstContact, sweep, listing } = state;
  const inStep = answer !== null && isInStep(answer.shot, state);
  const touches = listing === 'clip' ? sweep.total?.touches : answer?.touches;
  return (
    <section aria-labelledby="contacts">
      <h2 id="contacts">
        Contacts
        <output
          class={answer?.contacts ? 'number glowing' : 'number'}
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
        <label class="switch" title="Stop each query at its first contact (F)">
          <input
            type="checkbox"
            role="switch"
            checked={firstContact}
            onChange={() => update(toggleFirstContact)}
          />
          first only
        </label>
      </div>
      {listing === 'clip' && <Stills state={state} update={update} />}
      {listing === 'clip' && <Pairs state={state} touches={touches ?? []} />}
      <Touches touches={touches ?? []} />
    </section>
  );
}

/** Whether the answer is to the scene as it is now, at whatever frame. */
function isInStep(shot: Shot, { scene, firstContact, boxLevel }: State): boolean {
  return shot.scene === scene && shot.firstContact === firstContact && shot.boxLevel === boxLevel;
}

function Touches({ touches }: { touches: readonly Touch[] }) {
  if (touches.length === 0) return <p class="quiet">Nothing touches.</p>;
  const withParts = haveSeveralParts(touches);
  return (
    <>
      <ol class="touches">
        {touches.slice(0, MOST_ROWS).map(({ a, b, contacts }) => (
          <li>
            <Place surface={a} withPart={withParts} />
            <Place surface={b} withPart={withParts} />
            <output>{contacts.toLocaleString('en')}</output>
          </li>
        ))}
      </ol>
      {touches.length > MOST_ROWS && (
        <p class="quiet">and between {touches.length - MOST_ROWS} other pairs of joints</p>
      )}
    </>
  );
}

/** Whether a character touches with more than one of its parts. */
function haveSeveralParts(touches: readonly Touch[]): boolean {
  const places = touches.flatMap(({ a, b }) => [a, b]);
  const parts = new Set(places.map(({ instance, part }) => `${instance} ${part}`));
  return parts.size > new Set(places.map(({ instance }) => instance)).size;
}

export function Place({ surface, withPart }: { surface: Surface; withPart: boolean }) {
  const { instance, part, joint } = surface;
  return (
    <span class="place" title={`${part} · ${joint}`}>
      <i class="dot" style={{ background: cssColour(bodyColour(instance)) }} />
      {joint}
      {withPart && <small> {part}</small>}
    </span>
  );
}
