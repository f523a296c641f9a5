/** The scene as a file for the command, which answers with the same numbers. */

import type { CharacterFacts } from '../worker/protocol';
import type { Instance, Scene } from './scene';

export function sceneFile(scene: Scene, characters: readonly CharacterFacts[]): string {
  const models = Object.fromEntries(characters.map(({ name, source }) => [name, source]));
  const frames = { count: scene.frameCount, fps: scene.fps };
  const instances = scene.instances.map(({ character, morphWeights, ...rest }) => ({
    model: characters[character].name,
    ...rest,
    ...keptWeights(morphWeights),
  }));
  return JSON.stringify({ models, frames, instances }, null, 2) + '\n';
}

/** By names, or in the order of the targets where these have none. */
function keptWeights(weights: Instance['morphWeights']) {
  const targets = Object.keys(weights);
  if (targets.length === 0) return {};
  const areNumbers = targets.every((target) => /^\d+$/.test(target));
  return { morph_weights: areNumbers ? Object.values(weights) : weights };
}
