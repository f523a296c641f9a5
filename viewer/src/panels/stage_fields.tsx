import { MOST_FRAMES, type Scene } from '../scene/scene';
import { changeFps, changeFrameCount, rearrange } from '../state/changes';
import type { State, Update } from '../state/state';
import { memo } from './memo';
import { NumberField } from './number_field';

const FPS = { least: 1, most: 1000 };

interface StageProps extends Pick<Scene, 'frameCount' | 'fps'> {
  arrangement: State['arrangement'];
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
          value={arrangement}
          onChange={({ currentTarget }) =>
            update(rearrange(currentTarget.value as State['arrangement']))
          }
        >
          {wasPlaced && <option value="opened">as opened</option>}
          <option value="walking">walking in</option>
          <option value="together">in one place</option>
        </select>
      </label>
      <NumberField
        label="frames"
        title="Length of the scene in frames; by default that of the longest clip"
        step={1}
        least={1}
        most={MOST_FRAMES}
        value={frameCount}
        onChange={(count) => update(changeFrameCount(Math.round(count)))}
      />
      <NumberField
        label="fps"
        title="Frames per second"
        step={1}
        {...FPS}
        value={fps}
        onChange={(given) => update(changeFps(given))}
      />
    </div>
  ),
);
