/** Turns what the state says into questions to the worker, and its answers into state. */

import * as changes from '../state/changes';
import type { State } from '../state/state';
import type { Store } from '../state/store';
import type { Cost, Costs, Shot } from '../worker/protocol';
import type { Client } from './client';

/** Measuring costs the worker several times what it measures. */
const MEASURE_MILLISECONDS = 300;
const MEASURE_ROUNDS = 8;

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

  /** Again and again while the scene stands still: the least time is the one undisturbed. */
  private async measure(): Promise<void> {
    const shot = this.asked;
    if (this.isMeasuring || !shot || this.store.state.reading) return;
    this.isMeasuring = true;
    for (let round = 0; round < MEASURE_ROUNDS && isSame(shot, this.asked!); ++round) {
      const before = round === 0 ? null : this.store.state.costs;
      const asked = this.client.ask('measure', shot);
      await this.tell(asked, (costs) => ({ costs: before ? leastOf(costs, before) : costs }));
      await new Promise((resolve) => setTimeout(resolve, MEASURE_MILLISECONDS));
      if (this.store.state.reading) break;
    }
    this.isMeasuring = false;
    if (!isSame(shot, this.asked!)) void this.measure();
  }

  private sweepSoon(): void {
    this.store.update(({ sweep }) => ({
      sweep: { id: sweep.id + 1, counts: [], total: null },
      stills: [],
    }));
    this.sweepLater();
  }

  private sweepLater(): void {
    clearTimeout(this.sweepTimer);
    this.sweepTimer = window.setTimeout(() => this.sweep(), SWEEP_MILLISECONDS);
  }

  private sweep(): void {
    const { scene, firstContact, sweep, reading } = this.store.state;
    if (reading) return this.sweepLater();
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

/** While other characters are being read, the worker may have given up those of the scene. */
function shotOf({ scene, reading, frame, firstContact, boxLevel }: State): Shot | null {
  return scene && !reading ? { scene, frame, firstContact, boxLevel } : null;
}

function isSame(one: Shot, other: Shot): boolean {
  return (
    one.scene === other.scene &&
    one.frame === other.frame &&
    one.firstContact === other.firstContact &&
    one.boxLevel === other.boxLevel
  );
}

function leastOf(one: Costs, other: Costs): Costs {
  const least = (a: Cost, b: Cost) => (a.microseconds < b.microseconds ? a : b);
  return {
    onDemand: least(one.onDemand, other.onDemand),
    eager: least(one.eager, other.eager),
  };
}

function sweepsDiffer(state: State, before: State): boolean {
  return state.scene !== before.scene || state.firstContact !== before.firstContact;
}
