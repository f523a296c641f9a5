/** Finds the contacts of one character with itself: of each of its bodies, and of every two parts. */

import type { Character, Crowd, Pelt } from 'pelt';
import type { Body } from './bodies';
import type { SelfQuestion } from './protocol';
import type { SelfFilters } from './self_filters';

/** Pairs of triangles, [N][2]. */
export type Pairs = Uint32Array;

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
  if (parts.length > 0) {
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

  /** Returns the pairs of triangles in ascending order. */
  find(palette: Float32Array, weights: Float32Array): Pairs {
    for (let body = 0; body < this.count; ++body) {
      this.crowd.setPalette(body, palette);
      this.crowd.setMorphWeights(body, weights);
    }
    return ascending(this.crowd.collide().contacts, this.character.triangleCount);
  }

  delete(): void {
    this.crowd.delete();
  }
}

/** A crowd sorts contacts by bodies first. */
function ascending(contacts: Uint32Array, triangleCount: number): Pairs {
  const keys = new Float64Array(contacts.length / 4);
  for (let i = 0; i < keys.length; ++i) {
    keys[i] = contacts[4 * i + 2] * triangleCount + contacts[4 * i + 3];
  }
  keys.sort();
  const pairs = new Uint32Array(2 * keys.length);
  keys.forEach((key, i) => {
    pairs[2 * i] = Math.floor(key / triangleCount);
    pairs[2 * i + 1] = key % triangleCount;
  });
  return pairs;
}
