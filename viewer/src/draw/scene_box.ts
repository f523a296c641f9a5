/** Box of all characters over all frames. */

import { Box3, Matrix4, Quaternion, Vector3 } from 'three';
import { frameTime, placeAt } from '../scene/scene';
import type { Instance, Scene } from '../scene/types';
import type { CharacterFacts } from '../worker/protocol';

export function sceneBox(scene: Scene, characters: readonly CharacterFacts[]): Box3 {
  const all = new Box3();
  for (const instance of scene.instances) {
    for (const frame of [0, scene.frameCount - 1]) {
      all.union(boxAt(instance, characters[instance.character], frameTime(scene, frame)));
    }
  }
  return all;
}

function boxAt(instance: Instance, { extent }: CharacterFacts, time: number): Box3 {
  const placement = new Matrix4().compose(
    new Vector3(...placeAt(instance, time)),
    new Quaternion(...instance.rotation),
    new Vector3().setScalar(instance.scale),
  );
  const box = new Box3(new Vector3(...extent.low), new Vector3(...extent.high));
  return box.applyMatrix4(placement);
}
