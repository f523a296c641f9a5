/** The command that gives the numbers that the page shows, and the scene file for it. */

import type { By, CharacterFacts, FrameRange, ReadingOptions } from '../worker/protocol';
import { FPS } from './arrange';
import { castOf } from './cast';
import { framesOfLongestClip } from './scene';
import { selfKeys, selfWords } from './self';
import type { Instance, Scene, SelfChoices } from './types';

/** The query of the page. */
export interface Asking {
  scene: Scene;
  characters: readonly CharacterFacts[];
  by: By;
  /** Most contacts of each pair; null for all. */
  maxContacts: number | null;
  /** Largest distance of two triangles in contact; null if they have to touch. */
  clearance: number | null;
  /** Units of work for each pair of bodies; null: no limit. */
  budget: number | null;
  self: SelfChoices;
  /** Whether the steps between frames are tested, too. */
  between: boolean;
  /** Null for all frames. */
  frames: FrameRange | null;
  readingOptions: ReadingOptions;
}

export interface CheckCommand {
  words: string;
  /** Whether the command names the scene file that `Save scene` writes. */
  needsFile: boolean;
}

export function checkCommand(asking: Asking): CheckCommand {
  const needsFile = !isOfCommandLine(asking);
  const what = needsFile ? ['scene.json'] : modelWords(asking);
  return {
    words: ['pelt', 'check', ...what, ...optionWords(asking)].map(quoted).join(' '),
    needsFile,
  };
}

/** Whether the command alone gives the models this placement and this number of frames. */
function isOfCommandLine({ scene, characters }: Asking): boolean {
  return (
    scene.instances.every((instance) => isBare(instance, characters)) &&
    scene.ignore.length === 0 &&
    scene.fps === FPS &&
    scene.frameCount === framesOfLongestClip(scene, characters)
  );
}

function isBare(instance: Instance, characters: readonly CharacterFacts[]): boolean {
  const { character, clip, translation, rotation, scale, velocity, start, speed } = instance;
  const [x, y, z] = rotation;
  return (
    typeof characters[character].source === 'string' &&
    clip !== DEFAULT_POSE &&
    [...translation, ...velocity, x, y, z, start].every((value) => value === 0) &&
    scale === 1 &&
    speed === 1 &&
    Object.keys(instance.morphWeights).length === 0
  );
}

/** Value of `--clip` for the default pose. */
const DEFAULT_POSE = '-';

function modelWords({ scene: { instances }, characters }: Asking): string[] {
  const models = instances.map(({ character }) => characters[character].source as string);
  return [...models, ...instances.flatMap(({ clip }) => ['--clip', clip ?? DEFAULT_POSE])];
}

function optionWords(asking: Asking): string[] {
  const { by, maxContacts, clearance, budget, between, frames, readingOptions } = asking;
  const { renormalise, noUnskinned, exclude = [], skinning } = readingOptions;
  return [
    ...(by === 'part' ? ['--by', 'part'] : []),
    ...(frames ? ['--frames', frames.join(':')] : []),
    ...limitWords(maxContacts),
    ...(clearance === null ? [] : ['--clearance', String(clearance)]),
    ...(budget === null ? [] : ['--budget', String(budget)]),
    ...selfWords(asking),
    ...(between ? ['--between'] : []),
    ...(renormalise ? ['--renormalise'] : []),
    ...(skinning ? ['--skinning', skinning] : []),
    ...(noUnskinned ? ['--no-unskinned'] : []),
    ...exclude.flatMap((node) => ['--exclude', node]),
  ];
}

function limitWords(maxContacts: number | null): string[] {
  if (maxContacts === null) return [];
  return maxContacts === 1 ? ['--first'] : ['--max-contacts', String(maxContacts)];
}

/** Quotes a word for a shell. */
function quoted(word: string): string {
  return /^[\w./:@%+=-]+$/.test(word) ? word : `'${word.replaceAll("'", `'\\''`)}'`;
}

/** The scene as a file for the command, which answers with the same numbers. */
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
