/** Contacts that are looked at more closely: those between two places. */

import type { Character } from 'pelt';
import type { Spot, Surface } from './protocol';
import { surfaceOf } from './surfaces';

/** Selects the contacts of the spot from those of a crowd. */
export function contactsInSpot(
  characters: readonly Character[],
  contacts: Uint32Array,
  { a, b }: Spot,
): Uint32Array {
  const found: number[] = [];
  for (let i = 0; i < contacts.length; i += 4) {
    if (contacts[i] !== a.instance || contacts[i + 1] !== b.instance) continue;
    const [triangleA, triangleB] = [contacts[i + 2], contacts[i + 3]];
    if (isIn(characters, a, triangleA) && isIn(characters, b, triangleB)) {
      found.push(a.instance, b.instance, triangleA, triangleB);
    }
  }
  return Uint32Array.from(found);
}

function isIn(characters: readonly Character[], place: Surface, triangle: number): boolean {
  const { part, joint } = surfaceOf(characters[place.instance], place.instance, triangle);
  return part === place.part && joint === place.joint;
}
