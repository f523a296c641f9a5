import type { Instance } from '../scene/scene';
import { turnOf, withTurn } from '../scene/turn';
import { changeInstance, select } from '../state/changes';
import type { State, Update } from '../state/state';
import type { CharacterFacts } from '../worker/protocol';
import { Badge } from './badge';
import { memo } from './memo';
import { NumberField } from './number_field';

const SCALE = { least: 1e-3, most: 1e3 };

interface CardProps {
  index: number;
  instance: Instance;
  character: CharacterFacts;
  /** What its handles do, where it has some. */
  gizmo: State['gizmo'] | null;
  isOneOfMany: boolean;
  update: Update;
}

export const CharacterCard = memo((props: CardProps) => {
  const { index, character, gizmo, isOneOfMany, update } = props;
  const { name, triangles, warnings } = character;
  const isSelected = gizmo !== null;
  return (
    <article class={isSelected ? 'card selected' : 'card'}>
      <button
        class="title"
        aria-expanded={isSelected}
        onClick={() => update(select(isSelected ? null : index))}
        title={index < 10 ? `Place it (${index})` : 'Place it'}
      >
        <Badge instance={index} />
        <span>{name}</span>
        <small>{(triangles.length / 3).toLocaleString('en')} triangles</small>
      </button>
      {(isSelected || !isOneOfMany) && <Clip {...props} />}
      {isSelected && <Placement {...props} />}
      {isSelected && warnings.length > 0 && <Warnings warnings={warnings} />}
    </article>
  );
});

function Warnings({ warnings }: Pick<CharacterFacts, 'warnings'>) {
  return (
    <details>
      <summary>{warnings.length} things of this file are passed over</summary>
      <ul>
        {warnings.map((warning) => (
          <li>{warning}</li>
        ))}
      </ul>
    </details>
  );
}

function Clip({ character: { clips }, update, instance, index }: CardProps) {
  const change = changer(update, index);
  return (
    <div class="fields">
      <label class="wide">
        clip
        <select
          value={String(clips.findIndex((clip) => clip.name === instance.clip))}
          onChange={({ currentTarget }) =>
            change({ clip: clips[Number(currentTarget.value)]?.name ?? null })
          }
        >
          <option value="-1">default pose</option>
          {clips.map((clip, i) => (
            <option value={String(i)} disabled={isHidden(clips, i)}>
              {`${clip.name || 'unnamed'} · ${clip.seconds.toFixed(2)} s`}
            </option>
          ))}
        </select>
      </label>
      <NumberField
        label="start"
        unit="s"
        step={0.05}
        value={instance.start}
        onChange={(start) => change({ start })}
      />
      <NumberField
        label="speed"
        unit="×"
        step={0.1}
        value={instance.speed}
        onChange={(speed) => change({ speed })}
      />
    </div>
  );
}

/** Clips go by their names: of those with the same one, only the first can be played. */
function isHidden(clips: CharacterFacts['clips'], index: number): boolean {
  return clips.findIndex(({ name }) => name === clips[index].name) < index;
}

const AXES = ['x', 'y', 'z'];

function Placement({ update, instance, index, gizmo: shown }: CardProps) {
  const change = changer(update, index);
  const { translation, velocity, rotation, scale } = instance;
  const mode = (gizmo: State['gizmo'], key: string) => (
    <button
      aria-pressed={shown === gizmo}
      onClick={() => update(() => ({ gizmo }))}
      title={`Drag the handles to ${gizmo} (${key})`}
    >
      {gizmo}
    </button>
  );
  return (
    <div class="fields">
      {AXES.map((axis, i) => (
        <NumberField
          key={axis}
          label={axis}
          title="Place in frame 0"
          step={0.01}
          value={translation[i]}
          onChange={(value) => change({ translation: replaced(translation, i, value) })}
        />
      ))}
      <NumberField
        label="turn"
        unit="°"
        step={5}
        value={turnOf(rotation)}
        onChange={(degrees) => change({ rotation: withTurn(rotation, degrees) })}
      />
      {AXES.map((axis, i) => (
        <NumberField
          key={`velocity ${axis}`}
          label={`${axis}/s`}
          title="Way in a second"
          step={0.05}
          value={velocity[i]}
          onChange={(value) => change({ velocity: replaced(velocity, i, value) })}
        />
      ))}
      <NumberField
        label="scale"
        step={0.05}
        {...SCALE}
        value={scale}
        onChange={(value) => change({ scale: value })}
      />
      <div class="choice" role="group" aria-label="Handles">
        {mode('move', 'G')}
        {mode('turn', 'R')}
      </div>
    </div>
  );
}

function changer(update: Update, index: number) {
  return (change: Partial<Instance>) => update(changeInstance(index, change));
}

function replaced(vector: Instance['translation'], axis: number, value: number) {
  return vector.map((old, i) => (i === axis ? value : old)) as Instance['translation'];
}
