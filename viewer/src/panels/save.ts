import { sceneFile } from '../scene/scene_file';
import type { State } from '../state/state';

/** Lets the browser save the scene on the stage as a file. */
export function saveScene({ scene, characters, self }: State): void {
  if (!scene) return;
  const link = document.createElement('a');
  link.href = `data:application/json,${encodeURIComponent(sceneFile(scene, characters, self))}`;
  link.download = 'scene.json';
  link.click();
}
