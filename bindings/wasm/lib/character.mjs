import * as check from './checks.mjs';
import { clipNumber } from './lookup.mjs';
import { Pose } from './pose.mjs';
import { SelfFilter } from './self.mjs';

const kIdentity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

export class Character {
  #memory;
  #arrays = new Map();

  constructor(memory, address) {
    this.#memory = memory;
    const description = memory.json('describe_character', address);
    memory.handles.own(this, address, 'delete_character', `character ${description.name}`);
    Object.values(description).forEach(Object.freeze);
    Object.assign(this, description);
    Object.freeze(this);
  }

  get triangles() {
    return this.#array('triangles', Uint32Array);
  }

  get restPositions() {
    return this.#array('rest_positions', Float32Array);
  }

  get triangleJoints() {
    return this.#array('triangle_joints', Uint16Array);
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
    this.#memory.call('extent', this);
    return this.#memory.fields('low', 'high');
  }

  palette(clip, seconds, placement = kIdentity, out = undefined) {
    const number = this.#clipNumber(clip, seconds);
    check.vector(placement, 16, 'placement');
    this.#memory.call('sample_palette', this, number, seconds, Float32Array.from(placement));
    return this.#memory.array(Float32Array, 0, out);
  }

  morphWeights(clip, seconds, out = undefined) {
    this.#memory.call('sample_morph_weights', this, this.#clipNumber(clip, seconds), seconds);
    return this.#memory.array(Float32Array, 0, out);
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

  #clipNumber(clip, seconds) {
    check.number(seconds, 'seconds');
    return clipNumber(this.#memory, this, clip);
  }

  #array(name, type) {
    if (!this.#arrays.has(name)) {
      this.#memory.call(name, this);
      this.#arrays.set(name, this.#memory.array(type));
    }
    return this.#arrays.get(name);
  }
}
