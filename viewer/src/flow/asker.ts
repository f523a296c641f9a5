/** Sends requests to the worker, and changes the state by its answers or errors. */

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

  /** Returns the answer, after the state has been changed by it; nothing if there is none. */
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
