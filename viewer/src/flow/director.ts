/** Turns what the state says into questions to the worker, and its answers into state. */

import { newSweep, type AnsweredShot, type State } from '../state/state';
import type { Store } from '../state/store';
import type { Shot, Spare } from '../worker/protocol';
import type { Asker } from './asker';
import { checkedFrames } from '../state/frames';
import { isSameShot, selfOf, shotOf } from '../state/shots';
import { asksBetween } from '../state/steps';
import { isSameSelf } from '../scene/self';

/** While a gizmo is dragged, scenes follow each other faster than they can be swept. */
const SWEEP_MILLISECONDS = 150;

export class Director {
  private asked: Shot | null = null;
  private isPosing = false;
  /** Arrays of the answer that was shown before the present one. */
  private spares: Spare[] = [];
  private sweepTimer = 0;

  /** Has to listen after those who show answers. */
  constructor(
    private readonly store: Store<State>,
    private readonly asker: Asker,
  ) {
    store.listen((state, before) => {
      // Without an answer, the picture is still that of the answer before.
      if (state.answer && state.answer !== before.answer) this.spares = sparesOf(before.answer);
      if (sweepsDiffer(state, before)) this.sweepSoon();
      if (state.answer?.isPreliminary && hasBegun(state.sweep)) this.asked = null;
      void this.pose();
    });
  }

  /** Requests one frame at a time. Of frames wanted meanwhile, keeps only the last. */
  private async pose(): Promise<void> {
    const shot = shotOf(this.store.state);
    if (!shot || this.isPosing || (this.asked && isSameShot(shot, this.asked))) return;
    this.isPosing = true;
    this.asked = shot;
    const spares = this.spares;
    this.spares = [];
    await this.asker.ask('pose', { shot, spares }, (answer) => ({ answer: { ...answer, shot } }));
    this.isPosing = false;
    void this.pose();
  }

  private sweepSoon(): void {
    this.store.update(({ sweep }) => ({ sweep: newSweep(sweep.id + 1), stills: [] }));
    this.sweepLater();
  }

  private sweepLater(): void {
    clearTimeout(this.sweepTimer);
    this.sweepTimer = window.setTimeout(() => this.sweep(), SWEEP_MILLISECONDS);
  }

  private sweep(): void {
    const { scene, by, maxContacts, clearance, budget, sweep, reading } = this.store.state;
    if (reading) return this.sweepLater();
    if (!scene) return;
    const frames = checkedFrames(this.store.state);
    const self = selfOf(this.store.state);
    const between = asksBetween(this.store.state);
    const query = { by, maxContacts, clearance, budget, self, between };
    void this.asker.ask('sweep', { id: sweep.id, scene, ...query, frames });
  }
}

function sparesOf(answer: AnsweredShot | null): Spare[] {
  return answer?.instances.map(({ positions, normals }) => ({ positions, normals })) ?? [];
}

/** From then on, all filters are ready. */
function hasBegun({ counts, total }: State['sweep']): boolean {
  return counts.length > 0 || total !== null;
}

function sweepsDiffer(state: State, before: State): boolean {
  return (
    state.scene !== before.scene ||
    state.frames !== before.frames ||
    state.by !== before.by ||
    state.maxContacts !== before.maxContacts ||
    state.clearance !== before.clearance ||
    state.budget !== before.budget ||
    asksBetween(state) !== asksBetween(before) ||
    !isSameSelf(selfOf(state), selfOf(before))
  );
}
