/** The characters in a scene, and copies of a scene with one instance more or less. */

import type { CharacterFacts } from '../worker/protocol';
import type { Scene, Vector3 } from './types';

/** Returns the number of the character of each instance. */
export function castOf({ instances }: Scene): number[] {
  return instances.map(({ character }) => character);
}

/** Returns the names of the characters, each once. */
export function nameOf(cast: readonly number[], characters: readonly CharacterFacts[]): string {
  return [...new Set(cast)].map((character) => characters[character].name).join(', ');
}

/** Returns the scene without an instance, named after the others. */
export function without(scene: Scene, index: number, characters: readonly CharacterFacts[]): Scene {
  const instances = scene.instances.filter((_, i) => i !== index);
  const left = { ...scene, instances };
  return { ...left, name: nameOf(castOf(left), characters) };
}

/** Distance of a copy, in widths. */
const ASIDE = 1.1;

/** Returns the scene with a copy of an instance beside it, as the last instance. */
export function duplicated(
  scene: Scene,
  index: number,
  characters: readonly CharacterFacts[],
): Scene {
  const instance = scene.instances[index];
  const { low, high } = characters[instance.character].extent;
  const [x, ...rest] = instance.translation;
  const aside = ASIDE * instance.scale * (high[0] - low[0]);
  const copy = { ...instance, translation: [x + aside, ...rest] as Vector3 };
  return { ...scene, instances: [...scene.instances, copy] };
}
