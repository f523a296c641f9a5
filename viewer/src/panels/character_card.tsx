import { useLayoutEffect, useRef } from 'preact/hooks';
import { turnOf, withTurn } from '../scene/scene';
import type { Instance } from '../scene/types';
import { select, toggleHidden } from '../state/changes';
import { changeInstance, duplicateInstance, removeInstance } from '../state/edits';
import { endEdit } from '../state/history';
import type { State, Update } from '../state/state';
import { counted } from '../words';
import type { CharacterFacts } from '../worker/protocol';
import { Badge } from './badge';
import { memo } from './memo';
import { NumberField } from './number_field';

const SCALE = { least: 1e-3, most: 1e3 };

interface CardProps {
  index: number;
  instance: Instance;
  character: CharacterFacts;
  gizmo: State['gizmo'];
  isSelected: boolean;
  isHidden: boolean;
  isOneOfMany: boolean;
  isOnlyOne: boolean;
  update: Update;
}

export const CharacterCard = memo((props: CardProps) => {
  const { index, character, isSelected, isHidden, isOneOfMany, update } = props;
  const { name, triangles, warnings } = character;
  const size = counted(triangles.length / 3, 'triangle');
  const card = useRef<HTMLElement>(null);
  useLayoutEffect(() => {
    if (isSelected) card.current?.scrollIntoView({ block: 'nearest' });
  }, [isSelected]);
  return (
    <article ref={card} class={isSelected ? 'card selected' : 'card'}>
      <div class="line">
        <button
          class="title"
          aria-expanded={isSelected}
          onClick={() => update(select(isSelected ? null : index))}
          title={`${name}, ${size}: place it${index < 10 ? ` (${index})` : ''}`}
        >
          <Badge instance={index} />
          <span>{name}</span>
          {isHidden && <small>hidden</small>}
        </button>
        {(isSelected || !isOneOfMany) && <Clip {...props} />}
      </div>
      {isSelected && <Actions {...props} />}
      {isSelected && <Placement {...props} />}
      {isSelected && warnings.length > 0 && <Warnings warnings={warnings} />}
    </article>
  );
});

function Actions({ index, isHidden, isOnlyOne, update }: CardProps) {
  return (
    <div class="actions" role="group" aria-label="Character">
      <button
        onClick={() => update(toggleHidden(index))}
        title="Hidden characters are not drawn; their contacts count (H)"
      >
        {isHidden ? 'Show' : 'Hide'}
      </button>
      <button onClick={() => update(duplicateInstance(index))} title="Add a copy beside it">
        Duplicate
      </button>
      <button
        disabled={isOnlyOne}
        onClick={() => update(removeInstance(index))}
        title={isOnlyOne ? 'The only character of the scene' : 'Take it out of the scene (Delete)'}
      >
        Remove
      </button>
    </div>
  );
}

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
  const onEnd = () => update(endEdit);
  const mode = (gizmo: 'move' | 'turn', key: string) => (
    <button
      aria-pressed={shown === gizmo}
      onClick={() => update(() => ({ gizmo: shown === gizmo ? null : gizmo }))}
      title={`Show handles in the picture, to ${gizmo} the character (${key})`}
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
        onEnd={onEnd}
        onChange={(value) => change({ start: value })}
      />
      {AXES.map((axis, i) => (
        <NumberField
          key={axis}
          label={axis}
          title="Position at frame 0"
          step={0.01}
          value={translation[i]}
          onEnd={onEnd}
          onChange={(value) => change({ translation: replaced(translation, i, value) })}
        />
      ))}
      <NumberField
        label="speed"
        unit="×"
        title="Playback speed of the clip"
        step={0.1}
        value={speed}
        onEnd={onEnd}
        onChange={(value) => change({ speed: value })}
      />
      {AXES.map((axis, i) => (
        <NumberField
          key={`velocity ${axis}`}
          label={`${axis}/s`}
          title="Units per second"
          step={0.05}
          value={velocity[i]}
          onEnd={onEnd}
          onChange={(value) => change({ velocity: replaced(velocity, i, value) })}
        />
      ))}
      <NumberField
        label="turn"
        unit="°"
        step={5}
        period={360}
        value={turnOf(rotation)}
        onEnd={onEnd}
        onChange={(degrees) => change({ rotation: withTurn(rotation, degrees) })}
      />
      <NumberField
        label="scale"
        step={0.05}
        {...SCALE}
        value={scale}
        onEnd={onEnd}
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
