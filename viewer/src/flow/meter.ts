/** Requests measurements: occasionally while the scene plays, and thoroughly while it is paused. */

import type { MeasuredShot, State } from '../state/state';
import type { Store } from '../state/store';
import type { Cost, Costs, Shot } from '../worker/protocol';
import type { Asker } from './asker';
import { isSameQuery } from '../state/shots';

/** Time between two measurements. */
const PAUSE_MILLISECONDS = { playing: 600, still: 200 };

/** Number of repetitions whose minimum counts as undisturbed. */
const ROUNDS = 6;

/** Share of the frames before in the mean that is shown while the scene plays. */
const MEMORY = 0.8;

/** Vertex limits of all instances for measuring while playing, and for measuring at all. */
const MOST_VERTICES = { playing: 100_000, still: 2_000_000 };

export class Meter {
  private isMeasuring = false;
  private rounds = 0;
  private lastId = 0;

  constructor(
    private readonly store: Store<State>,
    private readonly asker: Asker,
  ) {
    store.listen((state, before) => {
      const wasFolded = state.isWorkOpen && !before.isWorkOpen;
      if (state.answer !== before.answer || wasFolded) void this.measure();
    });
  }

  /** Continues while there is something to measure. */
  private async measure(): Promise<void> {
    if (this.isMeasuring) return;
    this.isMeasuring = true;
    for (let shot = this.wanted(); shot; shot = this.wanted()) {
      await this.measureOnce(shot);
      const { isPlaying } = this.store.state;
      await pause(PAUSE_MILLISECONDS[isPlaying ? 'playing' : 'still']);
    }
    this.isMeasuring = false;
  }

  private wanted(): Shot | null {
    const { answer, costs, isPlaying, isWorkOpen, reading, scene } = this.store.state;
    if (!isWorkOpen || !answer || reading || answer.shot.scene !== scene) return null;
    if (answer.shot.clearance !== null) return null; // refitting all has no query for distances
    if (answer.shot.budget !== null) return null; // nor one with a limit of the work
    if (answer.work.allVertices > MOST_VERTICES[isPlaying ? 'playing' : 'still']) return null;
    const isMeasured = costs !== null && isSameQuery(costs.shot, answer.shot);
    if (!isMeasured) this.rounds = 0;
    return this.rounds < ROUNDS ? answer.shot : null;
  }

  /** Bit by bit, and on to the end even where the scene has gone on: of one frame, or of none. */
  private async measureOnce(shot: Shot): Promise<void> {
    const id = ++this.lastId;
    while (shot.scene === this.store.state.scene && !this.store.state.reading) {
      const costs = await this.asker.ask('measure', { id, shot });
      if (costs === undefined) this.rounds = ROUNDS;
      if (costs) this.store.update((state) => ({ costs: better(state, costs, shot) }));
      if (costs !== null) break;
    }
    ++this.rounds;
  }
}

function better({ costs: before, isPlaying }: State, costs: Costs, shot: Shot): MeasuredShot {
  if (before && isSameQuery(before.shot, shot)) {
    const least = (a: Cost, b: Cost) => (a.microseconds < b.microseconds ? a : b);
    return {
      ...costs,
      shot,
      frames: before.frames,
      onDemand: least(before.onDemand, costs.onDemand),
      eager: least(before.eager, costs.eager),
    };
  }
  if (!before || !isPlaying || before.shot.scene !== shot.scene)
    return { ...costs, shot, frames: 1 };
  return {
    ...costs,
    shot,
    frames: before.frames + 1,
    onDemand: mean(before.onDemand, costs.onDemand),
    eager: mean(before.eager, costs.eager),
  };
}

/** Later frames weigh more. */
function mean(before: Cost, { microseconds, ...cost }: Cost): Cost {
  return { ...cost, microseconds: MEMORY * before.microseconds + (1 - MEMORY) * microseconds };
}

function pause(milliseconds: number): Promise<void> {
  return new Promise((resolve) => setTimeout(resolve, milliseconds));
}
