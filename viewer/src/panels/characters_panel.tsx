import type { PanelProps } from './panel_props';
import { CharacterCard } from './character_card';
import { StageFields } from './stage_fields';

/** So many show what they play without being selected. */
const FEW = 4;

export function CharactersPanel({ state, update }: PanelProps) {
  const { scene, opened, arrangement, characters, selected, gizmo } = state;
  const isMany = (scene?.instances.length ?? 0) > FEW;
  return (
    <section aria-labelledby="characters">
      <h2 id="characters">
        Characters <small>drop .glb files to replace them</small>
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
