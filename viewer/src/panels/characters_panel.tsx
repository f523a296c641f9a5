import { notesOn } from '../scene/notes';
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
  const { scene, opened, arrangement, characters, selected, gizmo } = state;
  const isMany = (scene?.instances.length ?? 0) > FEW;
  return (
    <section aria-labelledby="characters">
      <h2 id="characters">
        Characters
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
          arrangement={arrangement}
          update={update}
        />
      )}
      {scene && !opened && <Notes notes={notesOn(scene, characters)} />}
      <div class={isMany ? 'many' : ''}>
        {scene?.instances.map((instance, i) => (
          <CharacterCard
            key={i}
            index={i}
            instance={instance}
            character={characters[instance.character]}
            gizmo={selected === i ? gizmo : null}
            isOneOfMany={isMany}
            update={update}
          />
        ))}
      </div>
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
