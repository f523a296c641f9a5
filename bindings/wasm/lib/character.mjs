import { alive, invalid } from './memory.mjs';
import { Pose } from './pose.mjs';

const kRemove = '_pelt_delete_character';

/** Stands for all parts together. */
const kWhole = 0xffffffff;
const kIdentity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

export class Character {
  #memory;
  #handle;
  #arrays = new Map();

  constructor(memory, handle) {
    this.#memory = memory;
    this.#handle = memory.own(this, handle, kRemove);
    Object.assign(this, memory.json(memory.module._pelt_describe_character(handle)));
  }

  /** For Pelt's own files. */
  get handle() {
    return alive(this.#handle, `character ${this.name}`);
  }

  get triangles() {
    return this.#array('_pelt_triangles', Uint32Array, 3);
  }

  get restPositions() {
    return this.#array('_pelt_rest_positions', Float32Array, 3);
  }

  get triangleJoints() {
    return this.#array('_pelt_triangle_joints', Uint16Array, 1);
  }

  get triangleParts() {
    if (!this.#arrays.has('parts')) {
      const parts = new Uint16Array(this.triangleCount);
      this.parts.forEach((part, p) => {
        parts.fill(p, part.firstTriangle, part.firstTriangle + part.triangleCount);
      });
      this.#arrays.set('parts', parts);
    }
    return this.#arrays.get('parts');
  }

  get extent() {
    this.#memory.module._pelt_extent(this.handle);
    return { low: this.#memory.numbers(0, 3), high: this.#memory.numbers(3, 6) };
  }

  palette(clip, seconds, placement = kIdentity, out = undefined) {
    const { module } = this.#memory;
    this.#memory.write(Float32Array, module._pelt_placement(), placement, 16, 'placement');
    module._pelt_sample_palette(this.handle, this.clipNumber(clip), seconds);
    return this.#memory.data(Float32Array, 16, out);
  }

  morphWeights(clip, seconds, out = undefined) {
    const { module } = this.#memory;
    module._pelt_sample_morph_weights(this.handle, this.clipNumber(clip), seconds);
    return this.#memory.data(Float32Array, 1, out);
  }

  makePose(part = null) {
    return new Pose(this.#memory, this, part);
  }

  delete() {
    this.#handle = this.#memory.disown(this, this.#handle, kRemove);
  }

  /** For Pelt's own files: -1 is no clip. */
  clipNumber(name) {
    if (name === null || name === undefined) return -1;
    const number = this.clips.findIndex((clip) => clip.name === name);
    if (number >= 0) return number;
    const known = this.clips.map((clip) => JSON.stringify(clip.name)).join(', ') || 'none';
    throw invalid(`${JSON.stringify(this.name)} has no clip ${JSON.stringify(name)}; it has ${known}`);
  }

  /** For Pelt's own files. */
  partNumber(part) {
    if (part === null) return kWhole;
    if (Number.isInteger(part) && part >= 0 && part < this.parts.length) return part;
    throw invalid(`part: ${JSON.stringify(this.name)} has no part ${part}`);
  }

  #array(name, type, width) {
    if (!this.#arrays.has(name)) {
      this.#memory.module[name](this.handle);
      this.#arrays.set(name, this.#memory.data(type, width));
    }
    return this.#arrays.get(name);
  }
}
