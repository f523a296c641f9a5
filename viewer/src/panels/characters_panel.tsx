import { notesOn } from '../scene/arrange';
import { MOST_FRAMES } from '../scene/scene';
import type { Scene } from '../scene/types';
import { toggleCards } from '../state/changes';
import { changeFps, changeFrameCount, rearrange } from '../state/edits';
import { endEdit } from '../state/history';
import type { State, Update } from '../state/state';
import { counted } from '../words';
import { CharacterCard } from './character_card';
import { memo } from './memo';
import { NumberField } from './number_field';
import type { PanelProps } from './panel_props';

/** Up to this number of characters, cards show the clip without being selected. */
const FEW = 4;

export function CharactersPanel({
  state,
  update,
  addFiles,
}: PanelProps & { addFiles: () => void }) {
  const {
    scene,
    opened,
    arranged,
    arrangement,
    characters,
    selected,
    gizmo,
    hidden,
    areCardsOpen,
  } = state;
  const isMany = (scene?.instances.length ?? 0) > FEW;
  const isOpen = !isMany || areCardsOpen || selected !== null;
  return (
    <section aria-labelledby="characters">
      <h2>
        <span id="characters">Characters</span>
        <small>drop files to replace them</small>
        <button
          class="add"
          onClick={addFiles}
          title="Add .glb files to these characters, or drop files with Shift held"
        >
          + Add
        </button>
      </h2>
      {scene && (
        <StageFields
          frameCount={scene.frameCount}
          fps={scene.fps}
          wasPlaced={opened !== null}
          arrangement={scene === arranged ? arrangement : null}
          update={update}
        />
      )}
      {scene && !opened && <Notes notes={notesOn(scene, characters)} />}
      {isMany && (
        <button class="fold" aria-expanded={isOpen} onClick={() => update(toggleCards)}>
          {counted(scene!.instances.length, 'character')}
        </button>
      )}
      {isOpen &&
        scene?.instances.map((instance, i) => (
          <CharacterCard
            key={i}
            index={i}
            instance={instance}
            character={characters[instance.character]}
            gizmo={gizmo}
            isSelected={selected === i}
            isHidden={hidden.has(i)}
            isOneOfMany={isMany}
            isOnlyOne={scene.instances.length === 1}
            update={update}
          />
        ))}
    </section>
  );
}

function Notes({ notes }: { notes: readonly string[] }) {
  return (
    <>
      {notes.map((note) => (
        <p class="note">{note}</p>
      ))}
    </>
  );
}

const FPS = { least: 1, most: 1000 };

interface StageProps extends Pick<Scene, 'frameCount' | 'fps'> {
  /** Null once the scene has been changed. */
  arrangement: State['arrangement'] | null;
  /** The scene has its own placements. */
  wasPlaced: boolean;
  update: Update;
}

/** Arrangement and length of the scene. */
const StageFields = memo(({ arrangement, wasPlaced, frameCount, fps, update }: StageProps) => (
  <div class="fields">
    <label class="wide" title="Place all characters again">
      arrangement
      <select
        value={arrangement ?? 'changed'}
        onChange={({ currentTarget }) =>
          update(rearrange(currentTarget.value as State['arrangement']))
        }
      >
        {arrangement === null && (
          <option value="changed" disabled>
            changed
          </option>
        )}
        {wasPlaced && <option value="opened">as opened</option>}
        <option value="walking">walking towards each other</option>
        <option value="together">all in the same place</option>
      </select>
    </label>
    <NumberField
      label="frames"
      title="Length of the scene in frames; by default that of the longest clip"
      step={1}
      least={1}
      most={MOST_FRAMES}
      value={frameCount}
      onEnd={() => update(endEdit)}
      onChange={(count) => update(changeFrameCount(Math.round(count)))}
    />
    <NumberField
      label="fps"
      title="Frames per second"
      step={1}
      {...FPS}
      value={fps}
      onEnd={() => update(endEdit)}
      onChange={(given) => update(changeFps(given))}
    />
  </div>
));
