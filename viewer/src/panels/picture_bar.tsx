import { cssColour, OPENED, REFITTED, UNTOUCHED } from '../draw/colours';
import { deepestLevel, moveCamera, toBoxLevel, toggleBoxes } from '../state/changes';
import { withCommas } from '../words';
import type { PanelProps } from './panel_props';

const LEGEND = [
  { colour: OPENED, state: 2, meaning: 'opened' },
  { colour: REFITTED, state: 1, meaning: 'refitted' },
  { colour: UNTOUCHED, state: 0, meaning: 'untouched' },
];

/** Controls on top of the picture: camera and bounds. */
export function PictureBar({ state, update }: PanelProps) {
  const { boxLevel, characters, scene } = state;
  if (!scene) return null;
  return (
    <section class="picture-bar" aria-label="Picture">
      <button
        title="See the whole scene (C)"
        aria-label="Whole scene"
        onClick={() => update(moveCamera({ kind: 'whole' }))}
      >
        <svg viewBox="0 0 16 16" aria-hidden="true">
          <path d="M2 6V2h4M10 2h4v4M14 10v4h-4M6 14H2v-4" />
        </svg>
      </button>
      <label class="switch" title="Draw the boxes of one level of the trees (B)">
        <input
          type="checkbox"
          role="switch"
          aria-label="Draw bounds"
          checked={boxLevel !== null}
          onChange={() => update(toggleBoxes)}
        />
        bounds
      </label>
      {boxLevel !== null && (
        <>
          <label class="level">
            level {boxLevel}
            <input
              type="range"
              min={0}
              max={deepestLevel(characters)}
              value={String(boxLevel)}
              title="[ and ]"
              onInput={({ currentTarget }) => update(toBoxLevel(Number(currentTarget.value)))}
            />
          </label>
          <Legend state={state} />
        </>
      )}
    </section>
  );
}

function Legend({ state: { answer } }: Pick<PanelProps, 'state'>) {
  const counts = [0, 0, 0];
  for (const { boxStates } of answer?.instances ?? []) {
    for (const boxState of boxStates) ++counts[boxState];
  }
  return (
    <ul class="legend">
      {LEGEND.map(({ colour, state, meaning }) => (
        <li>
          <i class="dot" style={{ background: cssColour(colour) }} />
          {withCommas(counts[state])} {meaning}
        </li>
      ))}
    </ul>
  );
}
