/** Characters for the stage, and the scene that came with them. */

import { MeshoptDecoder } from 'meshoptimizer/decoder';
import type { Character, MeshoptDecode, Pelt, Scene as EngineScene } from 'pelt';
import type { ModelSource, Scene, SelfChoices } from '../scene/types';
import { buffersOf, filesOfScene } from './find_files';
import {
  isCharacter,
  type CharacterFacts,
  type NamedFile,
  type Questions,
  type ReadingOptions,
  type Refusal,
} from './protocol';

export interface Cast {
  characters: Character[];
  /** The model of each character in a scene file. */
  sources: ModelSource[];
  scene: Scene | null;
  /** Choices of the scene file. */
  self: SelfChoices;
  /** Files that are no good, beside those that are. */
  refused: Refusal[];
}

const DEMO = 'two generated characters';

/** The scene of `pelt demo`, in half steps: pictures that follow each other at 60 a second. */
export function readDemo(pelt: Pelt): Cast {
  const file = JSON.parse(pelt.demoScene);
  file.frames = { count: 2 * file.frames.count, fps: 2 * file.frames.fps };
  const text = new TextEncoder().encode(JSON.stringify(file));
  return castOf(pelt.readScene(DEMO, { [DEMO]: text }), file, DEMO);
}

export function readSceneFile(
  pelt: Pelt,
  { path, files: dropped, options }: Questions['openScene'],
): Cast {
  const { path: place, files } = filesOfScene(path, dropped);
  const scene = pelt.readScene(place, files, { ...options, meshoptDecode });
  return castOf(scene, JSON.parse(new TextDecoder().decode(files.get(place))), path);
}

/** Returns the readable characters. Throws the errors of the others if there are none. */
export function readCharacters(
  pelt: Pelt,
  files: readonly NamedFile[],
  reading: ReadingOptions = {},
): Cast {
  const cast: Cast = { characters: [], sources: [], scene: null, self: {}, refused: [] };
  for (const model of files.filter(isCharacter)) {
    const { path } = model;
    const options = { ...reading, name: path, files: buffersOf(model, files), meshoptDecode };
    try {
      cast.characters.push(pelt.readCharacter(model.bytes, options));
      cast.sources.push(path);
    } catch (error) {
      if (pelt.hasEnded) throw error;
      cast.refused.push({ path, message: (error as Error).message });
    }
  }
  if (cast.characters.length > 0) return cast;
  throw new Error(cast.refused.map(({ message }) => message).join('\n'));
}

function castOf(
  { characters, frameCount, fps, instances, ignore, self }: EngineScene,
  file: { models: Record<string, ModelSource> },
  name: string,
): Cast {
  return {
    characters,
    sources: characters.map((character) => file.models[character.name]),
    scene: { name, frameCount, fps, instances, ignore },
    self,
    refused: [],
  };
}

const meshoptDecode: MeshoptDecode = (target, count, size, source, mode, filter) =>
  MeshoptDecoder.decodeGltfBuffer(target, count, size, source, mode, filter);

export function decodeFiles(files: Readonly<Record<string, string>>): NamedFile[] {
  return Object.entries(files).map(([path, base64]) => ({ path, bytes: decode(base64) }));
}

function decode(base64: string): Uint8Array<ArrayBuffer> {
  const letters = atob(base64);
  const bytes = new Uint8Array(letters.length);
  for (let i = 0; i < bytes.length; ++i) bytes[i] = letters.charCodeAt(i);
  return bytes;
}

export function factsOf(character: Character, source: ModelSource): CharacterFacts {
  const { name, triangles, vertexCount, levelCount, clips, extent, warnings } = character;
  const partCount = character.parts.filter((part) => part.triangleCount > 0).length;
  return { name, source, triangles, vertexCount, levelCount, partCount, clips, extent, warnings };
}
