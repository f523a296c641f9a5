import { pauseAt } from '../state/changes';
import { showsStills } from '../state/counts';
import { withCommas } from '../words';
import type { PanelProps } from './panel_props';

/** The worst frames; each leads there. */
export function Stills({ state, update }: PanelProps) {
  if (!showsStills(state)) return null;
  const { stills } = state;
  return (
    <div class="stills">
      {stills.map(({ frame, contacts, picture }) => (
        <button title={`Go to frame ${frame}`} onClick={() => update(pauseAt(frame))}>
          <img src={picture} alt={`Frame ${frame}`} />
          <span>
            {withCommas(contacts)} <small>frame {frame}</small>
          </span>
        </button>
      ))}
    </div>
  );
}
