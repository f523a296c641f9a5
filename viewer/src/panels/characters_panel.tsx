import { bodyColour, cssColour } from '../draw/colours';
import { turnOf, withTurn } from '../scene/turn';
import type { Instance } from '../scene/scene';
import { changeInstance, select } from '../state/changes';
import type { State, Update } from '../state/state';
import type { PanelProps } from './app';
import { NumberField } from './number_field';

export function CharactersPanel({ state, update }: PanelProps) {
  return (
    <section aria-labelledby="characters">
      <h2 id="characters">
        Characters <small>drop .glb files to replace them</small>
      </h2>
      {state.scene?.instances.map((instance, i) => (
        <Card key={i} state={state} update={update} instance={instance} index={i} />
      ))}
    </section>
  );
}

interface CardProps extends PanelProps {
  instance: Instance;
  index: number;
}

function Card({ state, update, instance, index }: CardProps) {
  const { name, triangles, warnings } = state.characters[instance.character];
  const isSelected = state.selected === index;
  return (
    <article class={isSelected ? 'card selected' : 'card'}>
      <button
        class="title"
        aria-expanded={isSelected}
        onClick={() => update(select(isSelected ? null : index))}
        title={`Place it (${index + 1})`}
      >
        <i class="dot" style={{ background: cssColour(bodyColour(index)) }} />
        <span>{name}</span>
        <small>{(triangles.length / 3).toLocaleString('en')} triangles</small>
      </button>
      <Clip state={state} update={update} instance={instance} index={index} />
      {isSelected && <Placement state={state} update={update} instance={instance} index={index} />}
      {isSelected && warnings.length > 0 && (
        <details>
          <summary>{warnings.length} things of this file are passed over</summary>
          <ul>
            {warnings.map((warning) => (
              <li>{warning}</li>
            ))}
          </ul>
        </details>
      )}
    </article>
  );
}

function Clip({ state, update, instance, index }: CardProps) {
  const { clips } = state.characters[instance.character];
  const change = changer(update, index);
  return (
    <div class="fields">
      <label class="wide">
        clip
        <select
          value={clips.findIndex((clip) => clip.name === instance.clip)}
          onChange={({ currentTarget }) =>
            change({ clip: clips[Number(currentTarget.value)]?.name ?? null })
          }
        >
          <option value={-1}>default pose</option>
          {clips.map((clip, i) => (
            <option value={i}>{`${clip.name || 'unnamed'} · ${clip.seconds.toFixed(2)} s`}</option>
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

function Placement({ state, update, instance, index }: CardProps) {
  const change = changer(update, index);
  const { translation, rotation } = instance;
  const mode = (gizmo: State['gizmo'], key: string) => (
    <button
      aria-pressed={state.gizmo === gizmo}
      onClick={() => update(() => ({ gizmo }))}
      title={`Drag the handles to ${gizmo} (${key})`}
    >
      {gizmo}
    </button>
  );
  return (
    <div class="fields">
      {['x', 'y', 'z'].map((axis, i) => (
        <NumberField
          key={axis}
          label={axis}
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
