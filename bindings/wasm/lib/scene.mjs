import { invalid } from './memory.mjs';

const kDefaults = {
  clip: null,
  start: 0,
  speed: 1,
  translation: [0, 0, 0],
  rotation: [0, 0, 0, 1],
  scale: 1,
  velocity: [0, 0, 0],
  morphWeights: {},
};

/** A copy of an instance, with every key. */
function complete(instance) {
  return structuredClone({ ...kDefaults, ...instance });
}

/** [M] what each target keeps; NaN: what the clip says. Targets go by name or else by number. */
function keptWeights(morphWeights, names) {
  const kept = new Float32Array(names.length).fill(NaN);
  for (const [target, weight] of Object.entries(morphWeights)) {
    const isTarget = (name, m) => name === target || (!names.includes(target) && `${m}` === target);
    if (!names.some(isTarget)) throw invalid(`morphWeights: there is no morph target "${target}"`);
    names.forEach((name, m) => {
      if (isTarget(name, m)) kept[m] = weight;
    });
  }
  return kept;
}

export class Scene {
  #memory;

  constructor(memory, { name = 'scene', characters, instances, frameCount = 1, fps = 30, ignore = [] }) {
    this.#memory = memory;
    Object.assign(this, { name, characters, frameCount, fps, ignore });
    this.instances = instances.map(complete);
  }

  palette(instance, frame, out = undefined) {
    const character = this.#write(instance);
    this.#memory.module._pelt_instance_palette(character.handle, frame / this.fps);
    return this.#memory.data(Float32Array, 16, out);
  }

  morphWeights(instance, frame, out = undefined) {
    const character = this.#write(instance);
    this.#memory.module._pelt_instance_morph_weights(character.handle, frame / this.fps);
    return this.#memory.data(Float32Array, 1, out);
  }

  setPose(pose, instance, frame) {
    if (this.#write(instance) !== pose.character) {
      throw invalid(`pose: it is of ${pose.character.name}, and not of the instance's character`);
    }
    const { module } = this.#memory;
    this.#memory.accepted(module._pelt_pose_instance(pose.handle, frame / this.fps));
  }

  delete() {
    for (const character of this.characters) character.delete();
  }

  /** Hands the instance over; returns its character. */
  #write(number) {
    const instance = this.instances[number];
    if (instance === undefined) throw invalid(`instance: the scene has no instance ${number}`);
    const character = this.characters[instance.character];
    if (character === undefined) {
      throw invalid(`instances[${number}].character: the scene has no character ${instance.character}`);
    }
    const { module } = this.#memory;
    const { start, speed, translation, rotation, scale, velocity, morphWeights } = { ...kDefaults, ...instance };
    const numbers = [
      character.clipNumber(instance.clip),
      start,
      speed,
      ...translation,
      ...rotation,
      scale,
      ...velocity,
    ];
    const place = `instances[${number}]`;
    this.#memory.write(Float64Array, module._pelt_instance(), numbers, 14, place);
    const kept = keptWeights(morphWeights, character.morphTargetNames);
    const address = module._pelt_kept_weights(kept.length);
    this.#memory.write(Float32Array, address, kept, kept.length, place);
    return character;
  }
}
