import type { Instance } from '../scene/scene';
import { turnOf, withTurn } from '../scene/turn';
import { changeInstance, select } from '../state/changes';
import type { State, Update } from '../state/state';
import type { CharacterFacts } from '../worker/protocol';
import { counted } from '../words';
import { Badge } from './badge';
import { memo } from './memo';
import { NumberField } from './number_field';

const SCALE = { least: 1e-3, most: 1e3 };

interface CardProps {
  index: number;
  instance: Instance;
  character: CharacterFacts;
  /** Mode of the handles; null without handles. */
  gizmo: State['gizmo'] | null;
  isOneOfMany: boolean;
  update: Update;
}

export const CharacterCard = memo((props: CardProps) => {
  const { index, character, gizmo, isOneOfMany, update } = props;
  const { name, triangles, warnings } = character;
  const size = counted(triangles.length / 3, 'triangle');
  const isSelected = gizmo !== null;
  return (
    <article class={isSelected ? 'card selected' : 'card'}>
      <div class="line">
        <button
          class="title"
          aria-expanded={isSelected}
          onClick={() => update(select(isSelected ? null : index))}
          title={`${name}, ${size}: place it${index < 10 ? ` (${index})` : ''}`}
        >
          <Badge instance={index} />
          <span>{name}</span>
        </button>
        {(isSelected || !isOneOfMany) && <Clip {...props} />}
      </div>
      {isSelected && <Placement {...props} />}
      {isSelected && warnings.length > 0 && <Warnings warnings={warnings} />}
    </article>
  );
});

function Warnings({ warnings }: Pick<CharacterFacts, 'warnings'>) {
  return (
    <details>
      <summary>Ignored in this file: {counted(warnings.length, 'thing')}</summary>
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
    <select
      aria-label="clip"
      title="Clip"
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
  );
}

/** Clips are selected by name, so only the first of several clips with one name can be played. */
function isHidden(clips: CharacterFacts['clips'], index: number): boolean {
  return clips.findIndex(({ name }) => name === clips[index].name) < index;
}

const AXES = ['x', 'y', 'z'];

/** Start and speed of the clip, and the placement. */
function Placement({ update, instance, index, gizmo: shown }: CardProps) {
  const change = changer(update, index);
  const { start, speed, translation, velocity, rotation, scale } = instance;
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
      <NumberField
        label="start"
        unit="s"
        title="Time in the clip at frame 0"
        step={0.05}
        value={start}
        onChange={(value) => change({ start: value })}
      />
      {AXES.map((axis, i) => (
        <NumberField
          key={axis}
          label={axis}
          title="Position at frame 0"
          step={0.01}
          value={translation[i]}
          onChange={(value) => change({ translation: replaced(translation, i, value) })}
        />
      ))}
      <NumberField
        label="speed"
        unit="×"
        title="Playback speed of the clip"
        step={0.1}
        value={speed}
        onChange={(value) => change({ speed: value })}
      />
      {AXES.map((axis, i) => (
        <NumberField
          key={`velocity ${axis}`}
          label={`${axis}/s`}
          title="Units per second"
          step={0.05}
          value={velocity[i]}
          onChange={(value) => change({ velocity: replaced(velocity, i, value) })}
        />
      ))}
      <NumberField
        label="turn"
        unit="°"
        step={5}
        value={turnOf(rotation)}
        onChange={(degrees) => change({ rotation: withTurn(rotation, degrees) })}
      />
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
