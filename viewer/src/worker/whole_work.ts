/** What refitting everything is, for an instance of a character: the same in every pose. */

import type { Character } from 'pelt';

export interface WholeWork {
  refits: number;
  posedVertices: number;
}

const known = new WeakMap<Character, WholeWork>();

export function wholeWorkOf(character: Character): WholeWork {
  const work = known.get(character) ?? refitOnce(character);
  known.set(character, work);
  return work;
}

function refitOnce(character: Character): WholeWork {
  const pose = character.makePose();
  const { refits, posedVertices } = pose.refitAll();
  pose.delete();
  return { refits, posedVertices };
}
