import { cssColour, OPENED, REFITTED, UNTOUCHED } from '../draw/colours';
import { toggleBoxes } from '../state/changes';
import type { PanelProps } from './app';

const LEGEND = [
  { colour: OPENED, state: 2, meaning: 'opened' },
  { colour: REFITTED, state: 1, meaning: 'refitted' },
  { colour: UNTOUCHED, state: 0, meaning: 'untouched' },
];

export function BoxesPanel({ state, update }: PanelProps) {
  const { boxLevel, characters, answer } = state;
  const deepest = Math.max(0, ...characters.map(({ levelCount }) => levelCount - 1));
  const states = answer?.instances.flatMap(({ boxStates }) => Array.from(boxStates)) ?? [];
  return (
    <section aria-labelledby="boxes">
      <h2 id="boxes">
        Bounds
        <label class="switch" title="Draw the boxes of one level of the trees (B)">
          <input
            type="checkbox"
            role="switch"
            aria-label="Draw bounds"
            checked={boxLevel !== null}
            onChange={() => update(toggleBoxes)}
          />
        </label>
      </h2>
      {boxLevel !== null && (
        <>
          <label class="level">
            level {boxLevel}
            <input
              type="range"
              min={0}
              max={deepest}
              value={boxLevel}
              title="[ and ]"
              onInput={({ currentTarget }) =>
                update(() => ({ boxLevel: Number(currentTarget.value) }))
              }
            />
          </label>
          <ul class="legend">
            {LEGEND.map(({ colour, state: wanted, meaning }) => (
              <li>
                <i class="dot" style={{ background: cssColour(colour) }} />
                {states.filter((boxState) => boxState === wanted).length} {meaning}
              </li>
            ))}
          </ul>
        </>
      )}
    </section>
  );
}
