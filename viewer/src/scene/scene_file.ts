/** The scene as a file for the command, which answers with the same numbers. */

import type { CharacterFacts } from '../worker/protocol';
import { castOf } from './cast';
import { selfKeys } from './self';
import type { Instance, Scene, SelfChoices } from './types';

export function sceneFile(
  scene: Scene,
  characters: readonly CharacterFacts[],
  self: SelfChoices,
): string {
  const names = distinct(characters.map(({ name }) => name));
  const cast = new Set(castOf(scene));
  const models = Object.fromEntries(
    [...characters.keys()].filter((i) => cast.has(i)).map((i) => [names[i], characters[i].source]),
  );
  const frames = { count: scene.frameCount, fps: scene.fps };
  const instances = scene.instances.map(({ character, morphWeights, ...rest }) => ({
    model: names[character],
    ...rest,
    ...keptWeights(morphWeights),
  }));
  const ignore = scene.ignore.length > 0 ? { ignore: scene.ignore } : {};
  const file = { models, frames, instances, ...ignore, ...selfKeys(self) };
  return JSON.stringify(file, null, 2) + '\n';
}

/** Weights by name, or in the order of the targets if these have no names. */
function keptWeights(weights: Instance['morphWeights']) {
  const targets = Object.keys(weights);
  if (targets.length === 0) return {};
  const areNumbers = targets.every((target) => /^\d+$/.test(target));
  return { morph_weights: areNumbers ? Object.values(weights) : weights };
}

/** Makes equal names distinct by numbers. */
function distinct(names: readonly string[]): string[] {
  const taken = new Set<string>();
  return names.map((name) => {
    let free = name;
    for (let number = 2; taken.has(free); ++number) free = `${name} (${number})`;
    taken.add(free);
    return free;
  });
}
