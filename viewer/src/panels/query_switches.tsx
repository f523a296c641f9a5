import { isOneBody, wantedSelf, type SelfAsking, type SelfWanted } from '../scene/self';
import { chooseSelf, limitContacts, toggleBetween, toggleBy, toggleLimit } from '../state/changes';
import type { State } from '../state/state';
import { asksBetween, whyNotBetween } from '../state/steps';
import { counted } from '../words';
import { NumberField } from './number_field';
import type { PanelProps } from './panel_props';

/** Switches of the query: instances or parts, all contacts or some of each pair. */
export function QuerySwitches({ state, update }: PanelProps) {
  const { by, characters } = state;
  const haveParts = characters.some(({ partCount }) => partCount > 1);
  return (
    <div class="row switches">
      {(haveParts || by === 'part') && (
        <label
          class="switch"
          title="Test all parts against each other, including parts of one character"
        >
          <input
            type="checkbox"
            role="switch"
            checked={by === 'part'}
            onChange={() => update(toggleBy)}
          />
          parts
        </label>
      )}
      <BetweenSwitch state={state} update={update} />
      <LimitSwitch state={state} update={update} />
      {state.maxContacts !== null && (
        <NumberField
          label="per pair"
          title="Most contacts of each pair in each frame"
          step={1}
          least={1}
          most={MOST_CONTACTS}
          value={state.maxContacts}
          onEnd={() => {}}
          onChange={(value) => update(limitContacts(Math.round(value)))}
        />
      )}
    </div>
  );
}

/** The largest limit of the engine. */
const MOST_CONTACTS = 2 ** 32 - 1;

/** Whether the steps between frames are tested, too. */
function BetweenSwitch({ state, update }: PanelProps) {
  const problem = whyNotBetween(state);
  return (
    <label
      class="switch"
      title={
        problem ??
        'Also find what touches only on the way from one frame to the next, in straight lines (E)'
      }
    >
      <input
        type="checkbox"
        role="switch"
        disabled={problem !== null}
        checked={asksBetween(state)}
        onChange={() => update(toggleBetween)}
      />
      between frames
    </label>
  );
}

function LimitSwitch({ state, update }: PanelProps) {
  return (
    <label class="switch" title={titleOfLimit(state)}>
      <input
        type="checkbox"
        role="switch"
        disabled={ignores(state) || state.budget !== null}
        checked={state.maxContacts !== null}
        onChange={() => update(toggleLimit)}
      />
      limit
    </label>
  );
}

function titleOfLimit(state: State): string {
  if (state.budget !== null) return 'Not available with a budget';
  if (ignores(state))
    return 'Not available: the first contacts may be those that the scene ignores';
  return `Stop each query after ${counted(state.lastMaxContacts, 'contact')} of a pair (F)`;
}

function ignores({ scene }: State): boolean {
  return scene !== null && scene.ignore.length > 0;
}

/** Whether characters are tested against themselves. */
export function SelfSwitch({ state, update }: PanelProps) {
  const { scene, by, characters, self, clearance, budget } = state;
  if (!scene || clearance !== null || budget !== null) return null;
  const asking = { scene, by, characters, self };
  const present = wantedSelf(asking);
  const thing = by === 'part' ? 'part' : 'character';
  return (
    <div class="self">
      <span class="quiet" id="self">
        self
      </span>
      <div class="choice" role="group" aria-labelledby="self">
        {choicesFor(asking).map(([wanted, name]) => (
          <button
            aria-pressed={present === wanted}
            title={TITLES[wanted].replace('thing', thing)}
            onClick={() => update(chooseSelf({ wanted }))}
          >
            {name}
          </button>
        ))}
      </div>
    </div>
  );
}

const TITLES: Record<SelfWanted, string> = {
  off: 'Test no thing against itself (X)',
  also: 'Test each thing against itself (X)',
  only: 'Test each thing against itself, and nothing else',
};

/** For a single body, "only" is the same as "also". */
function choicesFor(asking: SelfAsking): [SelfWanted, string][] {
  if (isOneBody(asking)) {
    return [
      ['off', 'off'],
      [wantedSelf(asking) === 'only' ? 'only' : 'also', 'on'],
    ];
  }
  return [
    ['off', 'off'],
    ['also', 'also'],
    ['only', 'only'],
  ];
}
