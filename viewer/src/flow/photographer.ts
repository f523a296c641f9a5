/** Takes stills of the worst frames, once all have been counted, each from where its contacts are
 * seen; and turns the stage so that one sees them. */

import { betterSide } from '../scene/sides';
import type { Vector3 } from '../scene/scene';
import type { AnsweredShot, State, Still } from '../state/state';
import type { Store } from '../state/store';
import type { Asker } from './asker';

const STILLS = 3;

export class Photographer {
  constructor(
    private readonly store: Store<State>,
    private readonly asker: Asker,
    private readonly picture: (answer: AnsweredShot, side: Vector3) => string,
  ) {
    store.listen((state, before) => {
      if (state.sweep.total && !before.sweep.total) void this.takeStills();
    });
  }

  private async takeStills(): Promise<void> {
    const { scene, by, firstContact, sweep } = this.store.state;
    if (!scene) return;
    const stills: Still[] = [];
    for (const frame of worstFrames(sweep.counts)) {
      if (this.store.state.reading) return;
      const shot = { scene, frame, by, firstContact, boxLevel: null, spot: null };
      const answer = await this.asker.ask('still', shot);
      if (!answer || this.store.state.sweep.id !== sweep.id) return;
      const side = betterSide(answer.seen);
      const picture = this.picture({ ...answer, shot }, side);
      stills.push({ frame, contacts: answer.contacts, side, picture });
    }
    this.store.update(({ side }) => ({ stills, side: side ?? worst(stills)?.side ?? null }));
  }
}

function worst(stills: readonly Still[]): Still | undefined {
  const most = Math.max(...stills.map(({ contacts }) => contacts));
  return stills.find(({ contacts }) => contacts === most);
}

/** Sorted by time, and far enough apart to differ. */
function worstFrames(counts: readonly number[]): number[] {
  const inContact = [...counts.keys()].filter((frame) => counts[frame] > 0);
  const apart = inContact.length / (2 * STILLS);
  const worst: number[] = [];
  for (const frame of inContact.sort((one, other) => counts[other] - counts[one])) {
    if (worst.every((taken) => Math.abs(taken - frame) > apart)) worst.push(frame);
  }
  return worst.slice(0, STILLS).sort((one, other) => one - other);
}
