/** Frames, places and times of a scene, and changes of it. */

import type { CharacterFacts, FrameRange } from '../worker/protocol';
import type { Instance, ModelSource, Quaternion, Scene, Vector3 } from './types';

/** The path of a file, unless the model is generated. */
export function fileOf(source: ModelSource): string | null {
  if (typeof source === 'string') return source;
  return 'file' in source ? source.file : null;
}

/** The same model from another file. */
export function withFile(source: ModelSource, file: string): ModelSource {
  return typeof source === 'string' ? file : { ...source, file };
}

/** More frames could not be counted in reasonable time, nor distinguished in a chart. */
export const MOST_FRAMES = 100_000;

/** Number of frames of `pelt check A.glb B.glb --clip ...`. */
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

/** Returns the time of a frame in seconds. */
export function frameTime(scene: Scene, frame: number): number {
  return frame / scene.fps;
}

/** Returns the position of an instance at a time. */
export function placeAt({ translation, velocity }: Instance, time: number): Vector3 {
  return [0, 1, 2].map((axis) => translation[axis] + velocity[axis] * time) as Vector3;
}

/** Returns the `translation` that puts the instance at a position at a time. */
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

/** The same duration with another frame rate. */
export function withFps(scene: Scene, fps: number): Scene {
  const frameCount = Math.round((scene.frameCount * fps) / scene.fps);
  return { ...scene, fps, frameCount: Math.min(Math.max(1, frameCount), MOST_FRAMES) };
}

/** Returns true for all frames if there is no range. */
export function isInRange(frame: number, range: FrameRange | null): boolean {
  if (!range) return true;
  const [first, end, step] = range;
  return frame >= first && frame < end && (frame - first) % step === 0;
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

/** Degrees from -180 to 180 by which a rotation turns around y, which points up (its twist). */
export function turnOf([, y, , w]: Quaternion): number {
  const degrees = (360 / Math.PI) * Math.atan2(y, w);
  return degrees > 180 ? degrees - 360 : degrees <= -180 ? degrees + 360 : degrees;
}

/** The rotation turned further until its turn is that. */
export function withTurn(rotation: Quaternion, degrees: number): Quaternion {
  const half = ((degrees - turnOf(rotation)) * Math.PI) / 360;
  const [sin, cos] = [Math.sin(half), Math.cos(half)];
  const [x, y, z, w] = rotation;
  return [cos * x + sin * z, cos * y + sin * w, cos * z - sin * x, cos * w - sin * y];
}
