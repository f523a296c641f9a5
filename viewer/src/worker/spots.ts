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
    const [first, second] = [contacts[i + 2], contacts[i + 3]];
    const areIn = (x: number, y: number) => isIn(characters, a, x) && isIn(characters, b, y);
    if (areIn(first, second)) found.push(a.instance, b.instance, first, second);
    // Contacts of an instance with itself have no sides.
    else if (a.instance === b.instance && areIn(second, first)) {
      found.push(a.instance, b.instance, second, first);
    }
  }
  return Uint32Array.from(found);
}

function isIn(characters: readonly Character[], place: Surface, triangle: number): boolean {
  const { part, joint } = surfaceOf(characters[place.instance], place.instance, triangle);
  return part === place.part && joint === place.joint;
}
