import * as check from './checks.mjs';
import { clipNumber } from './lookup.mjs';
import { Pose } from './pose.mjs';
import { SelfFilter } from './self.mjs';

const kRemove = '_pelt_delete_character';
const kIdentity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

export class Character {
  #memory;
  #arrays = new Map();

  constructor(memory, address) {
    this.#memory = memory;
    const description = memory.json(memory.module._pelt_describe_character(address));
    memory.handles.own(this, address, kRemove, `character ${description.name}`);
    Object.values(description).forEach(Object.freeze);
    Object.assign(this, description);
    Object.freeze(this);
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
    this.#memory.accepted(this.#memory.module._pelt_extent(this.#handle));
    return { low: this.#memory.field('low'), high: this.#memory.field('high') };
  }

  palette(clip, seconds, placement = kIdentity, out = undefined) {
    const { module } = this.#memory;
    const number = this.#clipNumber(clip, seconds);
    check.vector(placement, 16, 'placement');
    this.#memory.write(Float32Array, module._pelt_placement(), placement, 16, 'placement');
    module._pelt_sample_palette(this.#handle, number, seconds);
    return this.#memory.data(Float32Array, 16, out);
  }

  morphWeights(clip, seconds, out = undefined) {
    const number = this.#clipNumber(clip, seconds);
    this.#memory.module._pelt_sample_morph_weights(this.#handle, number, seconds);
    return this.#memory.data(Float32Array, 1, out);
  }

  makePose(part = null) {
    return new Pose(this.#memory, this, part);
  }

  makeSelfFilter(options = undefined, part = null) {
    return new SelfFilter(this.#memory, this, options, part);
  }

  delete() {
    this.#memory.handles.delete(this);
  }

  get #handle() {
    return this.#memory.handles.of(this);
  }

  #clipNumber(clip, seconds) {
    check.number(seconds, 'seconds');
    return clipNumber(this.#memory, this, clip);
  }

  #array(name, type, width) {
    if (!this.#arrays.has(name)) {
      this.#memory.module[name](this.#handle);
      this.#arrays.set(name, this.#memory.data(type, width));
    }
    return this.#arrays.get(name);
  }
}
