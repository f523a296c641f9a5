import { isOneBody, wantedSelf, type SelfAsking, type SelfWanted } from '../scene/self';
import { chooseSelf } from '../state/changes';
import type { PanelProps } from './panel_props';

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
