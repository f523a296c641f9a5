import { Character } from './character.mjs';
import * as check from './checks.mjs';
import { invalid } from './errors.mjs';
import { clipNumber } from './lookup.mjs';
import { readObject } from './options.mjs';
import { Pose } from './pose.mjs';

/** Limit of numbers, as in scene files: far beyond any use, but small enough to keep arithmetic finite. */
const kMaxNumber = 1e12;
const kMaxFactor = 1e6; // largest scale and frame rate; the least is its inverse

const number = (value, name) => check.number(value, name, -kMaxNumber, kMaxNumber);
const factor = (value, name) => check.number(value, name, 1 / kMaxFactor, kMaxFactor);
const vector = (value, name) => Array.from(check.vector(value, 3, name, kMaxNumber));

function quaternion(value, name) {
  const q = Array.from(check.vector(value, 4, name, kMaxNumber));
  if (Math.hypot(...q) === 0) throw invalid(`${name}: expected a quaternion, found one of length 0`);
  return q;
}

function weights(value, name) {
  for (const [target, weight] of Object.entries(check.object(value, name))) {
    number(weight, `${name}.${target}`);
  }
  return { ...value };
}

function list(value, name) {
  if (!Array.isArray(value)) throw invalid(`${name}: expected an array, found ${check.kindOf(value)}`);
  return value;
}

const kInstanceRules = {
  character: check.count,
  clip: check.optionalText,
  start: number,
  speed: number,
  translation: vector,
  rotation: quaternion,
  scale: factor,
  velocity: vector,
  morphWeights: weights,
};

const kSelfRules = {
  wanted: (value, name) => check.oneOf(value, ['off', 'also', 'only'], name),
  rings: (value, name) => check.count(value, name, 0, 64),
  dropsAtRest: check.flag,
  always: (value, name) => (value === null ? null : check.number(value, name, Number.MIN_VALUE, 1)),
  dropsNearJoints: check.flag,
};

const kPartsRules = {
  name: check.text,
  characters: list,
  instances: list,
  frameCount: (count, name) => check.count(count, name, 1),
  fps: factor,
  ignore: check.namePairs,
  self: check.object,
};

/** Returns a validated copy of an instance with all keys. */
function complete(memory, instance, place) {
  return {
    clip: null,
    start: 0,
    speed: 1,
    translation: [0, 0, 0],
    rotation: [0, 0, 0, 1],
    scale: 1,
    velocity: [0, 0, 0],
    morphWeights: {},
    ...readObject(memory, instance, kInstanceRules, place),
  };
}

/** Returns [M] fixed weights; NaN means the clip's. Targets are looked up by name, then by number. */
function keptWeights(morphWeights, names, place) {
  const kept = new Float32Array(names.length).fill(NaN);
  for (const [target, weight] of Object.entries(morphWeights)) {
    const isTarget = (name, m) => name === target || (!names.includes(target) && `${m}` === target);
    if (!names.some(isTarget)) {
      throw invalid(`${place}.morphWeights: there is no morph target ${JSON.stringify(target)}`);
    }
    names.forEach((name, m) => {
      if (isTarget(name, m)) kept[m] = weight;
    });
  }
  return kept;
}

export class Scene {
  #memory;

  constructor(memory, parts) {
    const read = readObject(memory, parts, kPartsRules, 'parts');
    const { name = 'scene', characters = [], instances = [], frameCount = 1, fps = 30, ignore = [] } = read;
    const self = readObject(memory, read.self ?? {}, kSelfRules, 'parts.self');
    characters.forEach((character, c) => {
      memory.handles.given(character, Character, `parts.characters[${c}]`);
    });
    this.#memory = memory;
    Object.assign(this, { name, characters: [...characters], frameCount, fps, ignore, self });
    this.instances = instances.map((one, i) => complete(memory, one, `parts.instances[${i}]`));
  }

  palette(instance, frame, out = undefined) {
    const { character, placed } = this.#placed(instance, frame);
    this.#memory.call('instance_palette', character, ...placed);
    return this.#memory.array(Float32Array, 0, out);
  }

  morphWeights(instance, frame, out = undefined) {
    const { character, placed } = this.#placed(instance, frame);
    this.#memory.call('instance_morph_weights', character, ...placed);
    return this.#memory.array(Float32Array, 0, out);
  }

  setPose(pose, instance, frame) {
    this.#memory.handles.given(pose, Pose, 'pose');
    const { character, placed } = this.#placed(instance, frame);
    if (character !== pose.character) {
      throw invalid(`pose: it belongs to ${pose.character.name}, not to the instance's character`);
    }
    this.#memory.call('pose_instance', pose, ...placed);
  }

  delete() {
    for (const character of this.characters) character.delete();
  }

  /** Returns an instance's character, and what the engine needs to place it. */
  #placed(number, frame) {
    const seconds = check.number(frame, 'frame') / factor(this.fps, 'fps');
    const place = `instances[${check.count(number, 'instance')}]`;
    if (!(number in this.instances)) throw invalid(`instance: the scene has no instance ${number}`);
    const instance = complete(this.#memory, this.instances[number], place);
    const character = this.characters[instance.character];
    this.#memory.handles.given(character, Character, `characters[${instance.character}]`);
    const kept = keptWeights(instance.morphWeights, character.morphTargetNames, place);
    const numbers = numbersOf(instance, clipNumber(this.#memory, character, instance.clip));
    return { character, placed: [seconds, numbers, kept] };
  }
}

/** Same order as PlacedNumbers (palette.cpp). */
function numbersOf({ start, speed, translation, rotation, scale, velocity }, clip) {
  return Float64Array.of(clip, start, speed, ...translation, ...rotation, scale, ...velocity);
}
