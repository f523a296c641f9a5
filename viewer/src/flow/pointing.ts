/** Asks what is under the pointer, one ray at a time: the last one counts. */

import * as changes from '../state/changes';
import type { Ray } from '../draw/pointer';
import type { State } from '../state/state';
import type { Store } from '../state/store';
import type { Questions } from '../worker/protocol';
import type { Asker } from './asker';

export class Pointing {
  private ray: Ray | null = null;
  private isAsking = false;

  constructor(
    private readonly store: Store<State>,
    private readonly asker: Asker,
  ) {}

  /** Selects the character that the ray hits, by mouse or by touch. */
  async select(ray: Ray): Promise<void> {
    const surface = await this.asker.ask('cast', this.questionOf(ray));
    this.store.update(changes.select(surface?.instance ?? null));
  }

  async point(ray: Ray | null): Promise<void> {
    this.ray = ray;
    if (this.isAsking) return;
    this.isAsking = true;
    while (this.ray) {
      const asked = this.ray;
      await this.asker.ask('cast', this.questionOf(asked), (hovered) => ({ hovered }));
      if (asked === this.ray) break;
    }
    this.isAsking = false;
    if (!this.ray && this.store.state.hovered) this.store.update(() => ({ hovered: null }));
  }

  private questionOf(ray: Ray): Questions['cast'] {
    return { ...ray, hidden: [...this.store.state.hidden] };
  }
}
