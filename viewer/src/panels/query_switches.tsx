import { toggleBy, toggleFirstContact } from '../state/changes';
import type { PanelProps } from './panel_props';

/** Switches of the query: instances or parts, all contacts or the first. */
export function QuerySwitches({ state, update }: PanelProps) {
  const { by, characters, firstContact, scene } = state;
  const haveParts = characters.some(({ partCount }) => partCount > 1);
  const ignores = (scene?.ignore.length ?? 0) > 0;
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
      <label
        class="switch"
        title={
          ignores
            ? 'Not available: the first contact may be one that the scene ignores'
            : 'Stop each query at its first contact (F)'
        }
      >
        <input
          type="checkbox"
          role="switch"
          disabled={ignores}
          checked={firstContact}
          onChange={() => update(toggleFirstContact)}
        />
        first only
      </label>
    </div>
  );
}
