/** A scene, as docs/scenes.md has it: what the command reads, the page shows. */

import type { Instance, NamePair } from 'pelt';
import type { CharacterFacts } from '../worker/protocol';

export type { Instance };

export type Vector3 = [number, number, number];
export type Quaternion = [number, number, number, number];

/** What a scene file says of a model: a file's path, or how to generate it. */
export type ModelSource =
  string | { creature: { triangles: number; joints: number; seed: number } };

export interface Scene {
  name: string;
  frameCount: number;
  fps: number;
  /** Their `character` is an index into `State.characters`. */
  instances: Instance[];
  /** Names of parts or joints whose contacts with each other do not count. */
  ignore: NamePair[];
}

/** More are neither counted in reasonable time nor told apart in a chart. */
export const MOST_FRAMES = 100_000;

/** As many as `pelt check A.glb B.glb --clip ...` asks. */
export function framesOfLongestClip(
  { instances, fps }: Scene,
  characters: readonly CharacterFacts[],
): number {
  const longest = Math.max(...instances.map((instance) => clipSeconds(instance, characters)));
  return Math.min(Math.max(1, Math.ceil(longest * fps)), MOST_FRAMES);
}

function clipSeconds({ character, clip }: Instance, characters: readonly CharacterFacts[]): number {
  return characters[character].clips.find(({ name }) => name === clip)?.seconds ?? 0;
}

/** Seconds at which a frame stands. */
export function frameTime(scene: Scene, frame: number): number {
  return frame / scene.fps;
}

/** Where an instance stands at a time. */
export function placeAt({ translation, velocity }: Instance, time: number): Vector3 {
  return [0, 1, 2].map((axis) => translation[axis] + velocity[axis] * time) as Vector3;
}

/** What `translation` has to be for the instance to stand there at that time. */
export function translationFor(place: Vector3, { velocity }: Instance, time: number): Vector3 {
  return [0, 1, 2].map((axis) => place[axis] - velocity[axis] * time) as Vector3;
}

/** The scene with one of its instances changed. */
export function withInstance(scene: Scene, index: number, change: Partial<Instance>): Scene {
  const instances = scene.instances.map((instance, i) =>
    i === index ? { ...instance, ...change } : instance,
  );
  return { ...scene, instances };
}

/** The same seconds in other steps. */
export function withFps(scene: Scene, fps: number): Scene {
  const frameCount = Math.round((scene.frameCount * fps) / scene.fps);
  return { ...scene, fps, frameCount: Math.min(Math.max(1, frameCount), MOST_FRAMES) };
}

/** The second scene, as long as its longest clip where the first was as long as its own. */
export function inWholeClips(
  scene: Scene,
  changed: Scene,
  characters: readonly CharacterFacts[],
): Scene {
  if (scene.frameCount !== framesOfLongestClip(scene, characters)) return changed;
  return { ...changed, frameCount: framesOfLongestClip(changed, characters) };
}
