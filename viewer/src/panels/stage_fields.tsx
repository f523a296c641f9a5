import { MOST_FRAMES } from '../scene/scene';
import type { Scene } from '../scene/types';
import { changeFps, changeFrameCount, rearrange } from '../state/edits';
import { endEdit } from '../state/history';
import type { State, Update } from '../state/state';
import { memo } from './memo';
import { NumberField } from './number_field';

const FPS = { least: 1, most: 1000 };

interface StageProps extends Pick<Scene, 'frameCount' | 'fps'> {
  /** Null once the scene has been changed. */
  arrangement: State['arrangement'] | null;
  /** The scene has its own placements. */
  wasPlaced: boolean;
  update: Update;
}

/** Arrangement and length of the scene. */
export const StageFields = memo(
  ({ arrangement, wasPlaced, frameCount, fps, update }: StageProps) => (
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
  ),
);
