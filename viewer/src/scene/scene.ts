/** A scene, as docs/scenes.md has it: what the command reads, the page shows. */

import type { Instance } from 'pelt';

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
