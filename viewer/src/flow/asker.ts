/** Asks the worker, and lets the state know of its answer, or of what went wrong. */

import * as changes from '../state/changes';
import type { State } from '../state/state';
import type { Store } from '../state/store';
import type { Answers, Kind, Questions } from '../worker/protocol';
import type { Client } from './client';

export class Asker {
  constructor(
    private readonly store: Store<State>,
    private readonly client: Client,
  ) {}

  /** The answer, once the state has changed by it; nothing if there is none. */
  async ask<K extends Kind>(
    kind: K,
    question: Questions[K],
    change: (answer: Answers[K]) => Partial<State> = () => ({}),
  ): Promise<Answers[K] | undefined> {
    try {
      const answer = await this.client.ask(kind, question);
      this.store.update(() => change(answer));
      return answer;
    } catch (error) {
      const message = error instanceof Error ? error.message : String(error);
      this.store.update(changes.refuse('The engine could not answer', message));
      return undefined;
    }
  }
}
