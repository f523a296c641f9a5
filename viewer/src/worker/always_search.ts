/**
 * Finds the pairs of triangles that touch in nearly all frames, one frame at a time, for the filter
 * that drops them.
 */

import type { Character, ContactTally, Pelt, Scene as EngineScene } from 'pelt';
import { partsOf } from './bodies';
import { OwnContacts, type SelfFilters } from './own_contacts';
import type { By, SelfQuestion } from './protocol';

export class AlwaysSearch {
  /** Of each instance. */
  private readonly queries: OwnContacts[];
  private readonly tallies: ReadonlyMap<Character, ContactTally>;

  constructor(
    pelt: Pelt,
    private readonly filters: SelfFilters,
    private readonly scene: EngineScene,
    private readonly by: By,
    private readonly self: SelfQuestion,
  ) {
    const question = { ...self, always: null };
    const characters = scene.instances.map(({ character }) => scene.characters[character]);
    this.queries = characters.map((character) => {
      return new OwnContacts(pelt, character, partsOf(character, by), filters, question);
    });
    this.tallies = new Map(
      [...new Set(characters)].map((character) => [character, pelt.makeContactTally()]),
    );
  }

  addFrame(frame: number): void {
    this.queries.forEach((query, i) => {
      const [palette, weights] = [this.scene.palette(i, frame), this.scene.morphWeights(i, frame)];
      this.tallies.get(query.character)!.add(query.find(palette, weights));
    });
  }

  /** Hands the pairs to the filters. */
  end(): void {
    const share = this.self.always!;
    const pairs = new Map(
      [...this.tallies].map(([character, tally]) => [character, tally.inShareOfPoses(share)]),
    );
    this.filters.knowAlways(this.scene, this.by, this.self, pairs);
  }

  delete(): void {
    for (const query of this.queries) query.delete();
    for (const tally of this.tallies.values()) tally.delete();
  }
}
