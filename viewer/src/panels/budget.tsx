/** What a limit of the work has left undecided. */

import { decideAll } from '../state/changes';
import { undecidedFrames } from '../state/counts';
import { counted, withCommas } from '../words';
import type { PanelProps } from './panel_props';

export function Budget({ state: { budget, sweep }, update }: PanelProps) {
  if (budget === null) return null;
  const { unknown, touching, decided } = undecidedFrames(sweep);
  return (
    <div class="budget">
      <p class="quiet">
        Each pair was given {counted(budget, 'unit')} of work in each frame.{' '}
        <button class="link" onClick={() => update(decideAll)}>
          Find all contacts
        </button>
      </p>
      <ul>
        <Row name="unknown" count={unknown} meaning="no contact found, some pairs not decided" />
        <Row name="touching" count={touching} meaning="more contacts are possible" />
        <Row name="decided" count={decided} meaning="all contacts found" />
      </ul>
    </div>
  );
}

interface RowProps {
  name: string;
  /** Number of frames. */
  count: number;
  meaning: string;
}

function Row({ name, count, meaning }: RowProps) {
  return (
    <li>
      <b data-fact={name}>{withCommas(count)}</b> {count === 1 ? 'frame' : 'frames'} {name}:{' '}
      {meaning}
    </li>
  );
}
