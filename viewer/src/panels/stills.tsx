import { pauseAt } from '../state/changes';
import { withCommas } from '../words';
import type { PanelProps } from './panel_props';

/** The worst frames; each leads there. */
export function Stills({ state: { scene, stills }, update }: PanelProps) {
  if (scene?.frameCount === 1) return null;
  return (
    <div class="stills">
      {stills.map(({ frame, contacts, picture }) => (
        <button title={`Go to frame ${frame}`} onClick={() => update(pauseAt(frame))}>
          <img src={picture} alt={`Frame ${frame}`} />
          <span>
            {withCommas(contacts)} <small>in {frame}</small>
          </span>
        </button>
      ))}
    </div>
  );
}
