import { notesOn } from '../scene/notes';
import { toggleCards } from '../state/changes';
import { counted } from '../words';
import type { PanelProps } from './panel_props';
import { CharacterCard } from './character_card';
import { StageFields } from './stage_fields';

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
