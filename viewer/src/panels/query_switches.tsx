import { toggleBy, toggleFirstContact } from '../state/changes';
import type { PanelProps } from './panel_props';

/** What is asked: instances or parts, all contacts or the first. */
export function QuerySwitches({ state, update }: PanelProps) {
  const { by, characters, firstContact, scene } = state;
  const haveParts = characters.some(({ partCount }) => partCount > 1);
  const ignores = (scene?.ignore.length ?? 0) > 0;
  return (
    <>
      {(haveParts || by === 'part') && (
        <label class="switch" title="All parts with each other, also those of one character">
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
            ? 'Not here: the contact found first may be one that the scene ignores'
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
    </>
  );
}
