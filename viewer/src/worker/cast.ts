/** Characters for the stage, and the scene that came with them. */

import type { Character, Files, MeshoptDecode, Pelt, Scene as EngineScene } from 'pelt';
import { MeshoptDecoder } from 'meshoptimizer/decoder';
import type { ModelSource, Scene } from '../scene/scene';
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
  return castOf(pelt.readScene(DEMO, { [DEMO]: text }), file.models);
}

export function readSceneFile(pelt: Pelt, { path, files, options }: Questions['openScene']): Cast {
  const byPath = new Map(files.map((file) => [file.path, file.bytes]));
  const scene = pelt.readScene(path, byPath, { ...options, meshoptDecode });
  return castOf(scene, JSON.parse(new TextDecoder().decode(byPath.get(path))).models);
}

export function readCharacters(pelt: Pelt, files: readonly NamedFile[]): Cast {
  const models = files.filter(isCharacter);
  const others = files.filter((file) => !isCharacter(file));
  const byPath: Files = new Map(others.map((file) => [file.path, file.bytes]));
  const characters: Character[] = [];
  try {
    for (const { path, bytes } of models) {
      characters.push(pelt.readCharacter(bytes, { name: path, files: byPath, meshoptDecode }));
    }
  } catch (error) {
    for (const character of characters) character.delete();
    throw error;
  }
  return { characters, sources: models.map(({ path }) => path), scene: null };
}

function castOf(scene: EngineScene, models: Record<string, ModelSource>): Cast {
  const { name, characters, frameCount, fps, instances } = scene;
  return {
    characters,
    sources: characters.map((character) => models[character.name]),
    scene: { name, frameCount, fps, instances },
  };
}

const meshoptDecode: MeshoptDecode = (target, count, size, source, mode, filter) =>
  MeshoptDecoder.decodeGltfBuffer(target, count, size, source, mode, filter);
