/** Finds the contacts of one character with itself: of each of its bodies, and of every two parts. */

import type { Character, Crowd, Pelt } from 'pelt';
import type { Body } from './bodies';
import type { SelfQuestion } from './protocol';
import type { SelfFilters } from './self_filters';

/** Applies the filters to the bodies of one character, which have these numbers in the crowd. */
export function setFilters(
  crowd: Crowd,
  character: Character,
  bodies: readonly { number: number; part: Body['part'] }[],
  filters: SelfFilters,
  question: SelfQuestion,
): void {
  for (const { number, part } of bodies) {
    crowd.setSelfFilter(number, filters.filterOf(character, part, question));
  }
  const parts = bodies.filter(({ part }) => part !== null).map(({ number }) => number);
  if (parts.length > 1) {
    crowd.filterParts(parts, filters.filterOf(character, null, question, 'part'));
  }
}

export class OwnContacts {
  private readonly crowd: Crowd;
  private readonly count: number;

  /** `parts`: null for the whole character. */
  constructor(
    pelt: Pelt,
    readonly character: Character,
    parts: readonly Body['part'][],
    filters: SelfFilters,
    question: SelfQuestion,
  ) {
    this.crowd = pelt.makeCrowd();
    this.count = parts.length;
    const bodies = parts.map((part) => ({ number: this.crowd.add(character, part), part }));
    setFilters(this.crowd, character, bodies, filters, question);
  }

  /** Calls back for each pair of triangles. */
  find(
    palette: Float32Array,
    weights: Float32Array,
    add: (triangleA: number, triangleB: number) => void,
  ): void {
    for (let body = 0; body < this.count; ++body) {
      this.crowd.setPalette(body, palette);
      this.crowd.setMorphWeights(body, weights);
    }
    const { contacts } = this.crowd.collide();
    for (let i = 0; i < contacts.length; i += 4) add(contacts[i + 2], contacts[i + 3]);
  }

  delete(): void {
    this.crowd.delete();
  }
}
