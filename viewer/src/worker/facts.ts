import type { Character } from 'pelt';
import type { ModelSource } from '../scene/types';
import type { CharacterFacts } from './protocol';

export function factsOf(character: Character, source: ModelSource): CharacterFacts {
  const { name, triangles, vertexCount, levelCount, clips, extent, warnings } = character;
  const partCount = character.parts.filter((part) => part.triangleCount > 0).length;
  return { name, source, triangles, vertexCount, levelCount, partCount, clips, extent, warnings };
}
