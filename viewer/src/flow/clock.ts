/** While the scene plays, frames follow the time that passes. */

import * as changes from '../state/changes';
import type { State } from '../state/state';
import type { Store } from '../state/store';

/** After a pause, for example of a hidden tab, the clock continues where it stopped. */
const LONGEST_STEP_SECONDS = 0.25;

export function startClock(store: Store<State>): void {
  let last = performance.now();
  let rest = 0; // fraction of the next frame

  const tick = (now: number) => {
    const seconds = Math.min((now - last) / 1000, LONGEST_STEP_SECONDS);
    last = now;
    const { scene, isPlaying, frame, answer, reading } = store.state;
    if (isPlaying && scene?.frameCount === 1) store.update(() => ({ isPlaying: false }));
    else if (scene && isPlaying && answer && !reading) {
      rest += seconds * scene.fps;
      const steps = Math.floor(rest);
      rest -= steps;
      if (steps > 0) store.update(changes.toFrame(frame + steps));
    }
    requestAnimationFrame(tick);
  };
  requestAnimationFrame(tick);
}
