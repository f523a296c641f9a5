/**
 * Once all contacts have been counted, turns the stage so that they are visible, and takes stills
 * of the worst frames while stills are shown.
 */

import { betterSide } from '../scene/sides';
import type { Vector3 } from '../scene/types';
import { showsStills, worstFrame, worstFrames } from '../state/counts';
import { shotOf } from '../state/shots';
import type { AnsweredShot, State, Still } from '../state/state';
import type { Store } from '../state/store';
import type { StillAnswer } from '../worker/protocol';
import type { Asker } from './asker';

export class Photographer {
  /** Counts whose side has been requested, and counts whose stills have been requested. */
  private sided: State['sweep']['total'] = null;
  private taken: State['sweep']['total'] = null;

  constructor(
    private readonly store: Store<State>,
    private readonly asker: Asker,
    private readonly picture: (answer: AnsweredShot, side: Vector3) => string,
  ) {
    store.listen((state) => this.work(state));
    this.work(store.state);
  }

  private work(state: State): void {
    const { side, sweep } = state;
    if (!sweep.total || state.reading) return;
    if (side === null && this.sided !== sweep.total) void this.findSide(state);
    if (showsStills(state) && this.taken !== sweep.total) void this.takeStills(state);
  }

  private async findSide({ sweep }: State): Promise<void> {
    this.sided = sweep.total;
    const frame = worstFrame(sweep.counts);
    const answer = frame === undefined ? null : await this.answerTo(frame, sweep.total);
    if (!answer) return;
    this.store.update(({ side }) => ({ side: side ?? betterSide(answer.seen) }));
  }

  private async takeStills({ sweep }: State): Promise<void> {
    this.taken = sweep.total;
    const stills: Still[] = [];
    for (const frame of worstFrames(sweep.counts)) {
      const answer = await this.answerTo(frame, sweep.total);
      if (!answer && this.store.state.reading) this.taken = null; // try again afterwards
      if (!answer) return;
      const side = betterSide(answer.seen);
      stills.push({ frame, contacts: answer.contacts, picture: this.picture(answer, side) });
    }
    this.store.update(() => ({ stills }));
  }

  /** Returns null if other contacts are being counted by now. */
  private async answerTo(
    frame: number,
    total: State['sweep']['total'],
  ): Promise<(AnsweredShot & StillAnswer) | null> {
    const wanted = shotOf(this.store.state);
    if (!wanted) return null;
    const shot = { ...wanted, frame, boxLevel: null, spot: null };
    const answer = await this.asker.ask('still', shot);
    return answer && this.store.state.sweep.total === total ? { ...answer, shot } : null;
  }
}
