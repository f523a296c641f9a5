import { toFrame } from '../state/changes';
import type { PanelProps } from './panel_props';

/** The worst frames; each leads there. */
export function Stills({ state: { stills }, update }: PanelProps) {
  return (
    <div class="stills">
      {stills.map(({ frame, contacts, picture }) => (
        <button
          title={`Go to frame ${frame}`}
          onClick={() => update((state) => ({ ...toFrame(frame)(state), isPlaying: false }))}
        >
          <img src={picture} alt={`Frame ${frame}`} />
          <span>
            {contacts.toLocaleString('en')} <small>in {frame}</small>
          </span>
        </button>
      ))}
    </div>
  );
}
