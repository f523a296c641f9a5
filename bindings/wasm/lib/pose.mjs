import * as check from './checks.mjs';
import { closestPoint, sideOf } from './distances.mjs';
import { partNumber } from './lookup.mjs';
import { cast, castAll, castAny } from './rays.mjs';
import { classify, findTriangles, intersectsRegion } from './solids.mjs';
import { readStats } from './stats.mjs';

const kRemove = '_pelt_delete_pose';

export const NodeState = Object.freeze({ untouched: 0, refitted: 1, opened: 2 });

export class Pose {
  #memory;

  constructor(memory, character, part) {
    this.#memory = memory;
    const made = memory.module._pelt_make_pose(
      memory.handles.of(character),
      partNumber(character, part),
    );
    memory.handles.own(this, memory.accepted(made), kRemove, `pose of ${character.name}`);
    this.character = character;
    this.part = part;
    Object.freeze(this);
  }

  setPalette(palette) {
    const { module } = this.#memory;
    const floats = 16 * this.character.jointCount;
    const address = module._pelt_pose_palette(this.#handle);
    this.#memory.write(Float32Array, address, palette, floats, 'palette');
    this.#memory.accepted(module._pelt_set_palette(this.#handle));
  }

  setDualQuaternions(dualQuaternions) {
    const { module } = this.#memory;
    const floats = 8 * this.character.jointCount;
    const address = module._pelt_pose_palette(this.#handle);
    this.#memory.write(Float32Array, address, dualQuaternions, floats, 'dualQuaternions');
    this.#memory.accepted(module._pelt_set_dual_quaternions(this.#handle));
  }

  setMorphWeights(weights) {
    const { module } = this.#memory;
    const floats = this.character.morphTargetNames.length;
    const address = module._pelt_pose_weights(this.#handle);
    this.#memory.write(Float32Array, address, weights, floats, 'weights');
    this.#memory.accepted(module._pelt_set_morph_weights(this.#handle));
  }

  setVertices(vertices) {
    const { module } = this.#memory;
    const address = module._pelt_given_vertices(this.#handle);
    this.#memory.write(Float32Array, address, vertices, 3 * this.character.vertexCount, 'vertices');
    this.#memory.accepted(module._pelt_set_vertices(this.#handle));
  }

  setOffsets(offsets) {
    const { module } = this.#memory;
    if (offsets === null) {
      this.#memory.accepted(module._pelt_remove_offsets(this.#handle));
      return;
    }
    const address = module._pelt_pose_offsets(this.#handle);
    this.#memory.write(Float32Array, address, offsets, 3 * this.character.vertexCount, 'offsets');
    this.#memory.accepted(module._pelt_set_offsets(this.#handle));
  }

  checkOffsets() {
    return this.#memory.module._pelt_check_offsets(this.#handle);
  }

  posedVertices(out = undefined) {
    this.#memory.module._pelt_posed_vertices(this.#handle);
    return this.#memory.data(Float32Array, 3, out);
  }

  normals(out = undefined) {
    this.#memory.module._pelt_normals(this.#handle);
    return this.#memory.data(Float32Array, 3, out);
  }

  openAll() {
    this.#memory.module._pelt_open_all(this.#handle);
    return readStats(this.#memory);
  }

  bounds(levels = 0) {
    this.#memory.module._pelt_bounds(this.#handle, check.count(levels, 'levels'));
    return this.#bounds();
  }

  exactBounds() {
    this.#memory.module._pelt_exact_bounds(this.#handle);
    return this.#bounds();
  }

  get nodeCount() {
    return this.#memory.module._pelt_node_count(this.#handle);
  }

  get openedNodeCount() {
    return this.#memory.module._pelt_opened_node_count(this.#handle);
  }

  nodeBoxes(level) {
    check.count(level, 'level');
    const states = this.#memory.module._pelt_node_boxes(this.#handle, level);
    const boxes = this.#memory.data(Float32Array, 1);
    const count = boxes.length / 6;
    return { count, boxes, states: this.#memory.copy(Uint8Array, states, count) };
  }

  get isClosed() {
    return this.#memory.module._pelt_is_closed(this.#handle) !== 0;
  }

  cast(origin, direction, options = undefined) {
    return cast(this.#memory, this.#handle, origin, direction, options);
  }

  castAny(origin, direction, options = undefined) {
    return castAny(this.#memory, this.#handle, origin, direction, options);
  }

  castAll(origin, direction, options = undefined) {
    return castAll(this.#memory, this.#handle, origin, direction, options);
  }

  classify(region) {
    return classify(this.#memory, this.#handle, region);
  }

  intersectsRegion(region) {
    return intersectsRegion(this.#memory, this.#handle, region);
  }

  findTriangles(region) {
    return findTriangles(this.#memory, this.#handle, region);
  }

  closestPoint(point, options = undefined) {
    return closestPoint(this.#memory, this.#handle, point, options);
  }

  sideOf(point) {
    return sideOf(this.#memory, this.#handle, this, point);
  }

  delete() {
    this.#memory.handles.delete(this);
  }

  get #handle() {
    return this.#memory.handles.of(this);
  }

  #bounds() {
    const memory = this.#memory;
    return {
      box: { low: memory.field('low'), high: memory.field('high') },
      centre: memory.field('centre'),
      radius: memory.field('radius'),
    };
  }
}
