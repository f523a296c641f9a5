/** Characters for the stage, and the scene that came with them. */

import type { Character, MeshoptDecode, Pelt, Scene as EngineScene } from 'pelt';
import { MeshoptDecoder } from 'meshoptimizer/decoder';
import type { ModelSource, Scene } from '../scene/scene';
import { buffersOf, filesOfScene } from './find_files';
import { isCharacter, type NamedFile, type Questions } from './protocol';

export interface Cast {
  characters: Character[];
  /** What a scene file says of each of them. */
  sources: ModelSource[];
  scene: Scene | null;
}

const DEMO = 'two generated characters';

/** The scene of `pelt demo`, in half steps: pictures that follow each other at 60 a second. */
export function readDemo(pelt: Pelt): Cast {
  const file = JSON.parse(pelt.demoScene);
  file.frames = { count: 2 * file.frames.count, fps: 2 * file.frames.fps };
  const text = new TextEncoder().encode(JSON.stringify(file));
  return castOf(pelt.readScene(DEMO, { [DEMO]: text }), file.models, DEMO);
}

export function readSceneFile(
  pelt: Pelt,
  { path, files: dropped, options }: Questions['openScene'],
): Cast {
  const { path: place, files } = filesOfScene(path, dropped);
  const scene = pelt.readScene(place, files, { ...options, meshoptDecode });
  const { models } = JSON.parse(new TextDecoder().decode(files.get(place)));
  return castOf(scene, models, path);
}

export function readCharacters(pelt: Pelt, files: readonly NamedFile[]): Cast {
  const models = files.filter(isCharacter);
  const characters: Character[] = [];
  try {
    for (const model of models) {
      const options = { name: model.path, files: buffersOf(model, files), meshoptDecode };
      characters.push(pelt.readCharacter(model.bytes, options));
    }
  } catch (error) {
    for (const character of characters) character.delete();
    throw error;
  }
  return { characters, sources: models.map(({ path }) => path), scene: null };
}

function castOf(
  { characters, frameCount, fps, instances, ignore }: EngineScene,
  models: Record<string, ModelSource>,
  name: string,
): Cast {
  return {
    characters,
    sources: characters.map((character) => models[character.name]),
    scene: { name, frameCount, fps, instances, ignore },
  };
}

const meshoptDecode: MeshoptDecode = (target, count, size, source, mode, filter) =>
  MeshoptDecoder.decodeGltfBuffer(target, count, size, source, mode, filter);
