/** The frames that are checked, where these are not all frames of the scene. */

import type { FrameRange } from '../worker/protocol';
import type { State } from './state';

/** Returns null if all frames are checked, also if the scene has become too short for the range. */
export function checkedFrames({
  frames,
  scene,
}: Pick<State, 'frames' | 'scene'>): FrameRange | null {
  return scene && frames && frames[1] <= scene.frameCount ? frames : null;
}

/** "85 to 89", "10 to 58 in steps of 3" */
export function rangeInWords([first, end, step]: FrameRange): string {
  const last = first + step * (Math.ceil((end - first) / step) - 1);
  return `${first} to ${last}${step > 1 ? ` in steps of ${step}` : ''}`;
}
