/**
 * Finds the pairs of triangles that touch in nearly all frames, one frame at a time, for the filter
 * that drops them.
 */

import type { Character, Pelt, Scene as EngineScene } from 'pelt';
import { partsOf } from './bodies';
import { OwnContacts } from './own_contacts';
import type { By, SelfQuestion } from './protocol';
import { pairKey, pairsOf, type SelfFilters } from './self_filters';

/** The poses of a character so far, and how many of them have each pair. */
interface Tally {
  poses: number;
  counts: Map<number, number>;
}

export class AlwaysSearch {
  /** Of each instance. */
  private readonly queries: OwnContacts[];
  private readonly tallies = new Map<Character, Tally>();

  constructor(
    pelt: Pelt,
    private readonly filters: SelfFilters,
    private readonly scene: EngineScene,
    private readonly by: By,
    private readonly self: SelfQuestion,
  ) {
    const question = { ...self, always: null };
    this.queries = scene.instances.map(({ character: number }) => {
      const character = scene.characters[number];
      return new OwnContacts(pelt, character, partsOf(character, by), filters, question);
    });
  }

  addFrame(frame: number): void {
    this.queries.forEach((query, i) => {
      const { character } = query;
      const tally = this.tallies.get(character) ?? { poses: 0, counts: new Map() };
      this.tallies.set(character, tally);
      ++tally.poses;
      query.find(this.scene.palette(i, frame), this.scene.morphWeights(i, frame), (a, b) => {
        const key = pairKey(character, a, b);
        tally.counts.set(key, (tally.counts.get(key) ?? 0) + 1);
      });
    });
  }

  /** Hands the pairs to the filters. */
  end(): void {
    const pairs = new Map(
      [...this.tallies].map(([character, tally]) => {
        return [character, pairsOf(character, oftenIn(tally, this.self.always!))] as const;
      }),
    );
    this.filters.knowAlways(this.scene, this.by, this.self, pairs);
  }

  delete(): void {
    for (const query of this.queries) query.delete();
  }
}

/** A quotient is rounded like the share: 55 of 100 poses are a share of 0.55. */
function oftenIn({ poses, counts }: Tally, share: number): number[] {
  return [...counts].filter(([, count]) => count / poses >= share).map(([key]) => key);
}
