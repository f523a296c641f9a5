/** Turns what the state says into questions to the worker, and its answers into state. */

import * as changes from '../state/changes';
import type { State } from '../state/state';
import type { Store } from '../state/store';
import type { Shot } from '../worker/protocol';
import type { Client } from './client';

/** Measuring costs the worker several times what it measures. */
const MEASURE_MILLISECONDS = 300;

/** While a gizmo is dragged, scenes follow each other faster than they can be swept. */
const SWEEP_MILLISECONDS = 150;

export class Director {
  private asked: Shot | null = null;
  private isPosing = false;
  private isMeasuring = false;
  private sweepTimer = 0;

  constructor(
    private readonly store: Store<State>,
    private readonly client: Client,
  ) {
    store.listen((state, before) => {
      if (sweepsDiffer(state, before)) this.sweepSoon();
      void this.pose();
    });
  }

  /** One frame at a time: what has been asked for meanwhile is left out but for the last. */
  private async pose(): Promise<void> {
    const shot = shotOf(this.store.state);
    if (!shot || this.isPosing || (this.asked && isSame(shot, this.asked))) return;
    this.isPosing = true;
    this.asked = shot;
    await this.tell(this.client.ask('pose', shot), (answer) => ({ answer: { ...answer, shot } }));
    this.isPosing = false;
    void this.measure();
    void this.pose();
  }

  private async measure(): Promise<void> {
    if (this.isMeasuring || !this.asked) return;
    this.isMeasuring = true;
    const shot = this.asked;
    await this.tell(this.client.ask('measure', shot), (costs) => ({ costs }));
    await new Promise((resolve) => setTimeout(resolve, MEASURE_MILLISECONDS));
    this.isMeasuring = false;
    if (!isSame(shot, this.asked)) void this.measure();
  }

  private sweepSoon(): void {
    clearTimeout(this.sweepTimer);
    this.store.update(({ sweep }) => ({
      sweep: { id: sweep.id + 1, counts: [], total: null },
      stills: [],
    }));
    this.sweepTimer = window.setTimeout(() => this.sweep(), SWEEP_MILLISECONDS);
  }

  private sweep(): void {
    const { scene, firstContact, sweep } = this.store.state;
    if (!scene) return;
    void this.tell(this.client.ask('sweep', { id: sweep.id, scene, firstContact }), () => ({}));
  }

  private async tell<Answer>(
    promise: Promise<Answer>,
    change: (answer: Answer) => Partial<State>,
  ): Promise<void> {
    try {
      const answer = await promise;
      this.store.update(() => change(answer));
    } catch (error) {
      this.store.update(changes.refuse('The engine could not answer', String(error)));
    }
  }
}

function shotOf({ scene, frame, firstContact, boxLevel }: State): Shot | null {
  return scene && { scene, frame, firstContact, boxLevel };
}

function isSame(one: Shot, other: Shot): boolean {
  return (
    one.scene === other.scene &&
    one.frame === other.frame &&
    one.firstContact === other.firstContact &&
    one.boxLevel === other.boxLevel
  );
}

function sweepsDiffer(state: State, before: State): boolean {
  return state.scene !== before.scene || state.firstContact !== before.firstContact;
}
