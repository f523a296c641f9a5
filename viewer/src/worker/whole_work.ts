/**
 * The work of refitting everything for an instance of a character or a part; the same in every
 * pose.
 */

import type { Character, Pose } from 'pelt';

export interface WholeWork {
  refits: number;
  posedVertices: number;
}

const known = new WeakMap<Character, Map<Pose['part'], WholeWork>>();

export function wholeWorkOf({ character, part }: Pose): WholeWork {
  const ofParts = known.get(character) ?? new Map();
  known.set(character, ofParts);
  const work = ofParts.get(part) ?? refitOnce(character, part);
  ofParts.set(part, work);
  return work;
}

function refitOnce(character: Character, part: Pose['part']): WholeWork {
  const pose = character.makePose(part);
  const { refits, posedVertices } = pose.openAll();
  pose.delete();
  return { refits, posedVertices };
}
