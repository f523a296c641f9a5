import type { Character } from 'pelt';
import type { ModelSource } from '../scene/scene';
import type { CharacterFacts } from './protocol';

export function factsOf(character: Character, source: ModelSource): CharacterFacts {
  const { name, triangles, vertexCount, levelCount, clips, extent, warnings } = character;
  return { name, source, triangles, vertexCount, levelCount, clips, extent, warnings };
}
