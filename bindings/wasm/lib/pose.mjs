/** Poses, and queries of a single pose. */

import * as check from './checks.mjs';
import { invalid } from './errors.mjs';
import { partNumber } from './lookup.mjs';
import { readOptions } from './options.mjs';
import { kPlacements, numbersOfRegion } from './regions.mjs';

export const NodeState = Object.freeze({ untouched: 0, refitted: 1, opened: 2 });

/** Numbered as in ray.hpp and inside.hpp. */
const kFacings = ['both', 'front', 'back'];
const kSides = ['outside', 'on', 'inside'];

/** Largest coordinate that queries accept. */
const kMaxCoordinate = 2 ** 60;

const parameter = (value, name) => check.number(value, name, -Infinity, Infinity);
const kRayRules = {
  minT: parameter,
  maxT: parameter,
  facing: (value, name) => check.oneOf(value, kFacings, name),
};
const kClosestRules = { maxDistance: (value, name) => check.number(value, name, 0, Infinity) };

/** Returns the points of the answer (distances.cpp). */
export function readPoints(memory) {
  const rows = memory.array(Float64Array);
  const points = [];
  for (let i = 0; i < rows.length; i += 7) {
    const [triangle, ...rest] = rows.subarray(i, i + 7);
    points.push({ triangle, position: rest.slice(0, 3), weights: rest.slice(3) });
  }
  return points;
}

/** Returns the hits of the answer (rays_and_regions.cpp). */
function readHits(memory) {
  const rows = memory.array(Float64Array);
  const hits = [];
  for (let i = 0; i < rows.length; i += 8) {
    const [triangle, t, ...rest] = rows.subarray(i, i + 8);
    hits.push({ triangle, t, weights: rest.slice(0, 3), normal: rest.slice(3) });
  }
  return hits;
}

export function requireClosed(pose) {
  if (!pose.isClosed) {
    throw invalid(`the surface of ${pose.character.name} is not closed: it has no inside`);
  }
}

export class Pose {
  #memory;

  constructor(memory, character, part) {
    this.#memory = memory;
    const made = memory.call('make_pose', character, partNumber(character, part));
    memory.handles.own(this, made, 'delete_pose', `pose of ${character.name}`);
    this.character = character;
    this.part = part;
    Object.freeze(this);
  }

  setPalette(palette) {
    this.#set('palette', palette, 16 * this.character.jointCount, 'palette');
  }

  setDualQuaternions(numbers) {
    this.#set('dual_quaternions', numbers, 8 * this.character.jointCount, 'dualQuaternions');
  }

  setMorphWeights(weights) {
    this.#set('morph_weights', weights, this.character.morphTargetNames.length, 'weights');
  }

  setVertices(vertices) {
    this.#set('vertices', vertices, 3 * this.character.vertexCount, 'vertices');
  }

  setOffsets(offsets) {
    const floats = offsets === null ? 0 : 3 * this.character.vertexCount;
    this.#set('offsets', offsets === null ? [] : offsets, floats, 'offsets');
  }

  checkOffsets() {
    return this.#memory.call('check_offsets', this);
  }

  posedVertices(out = undefined) {
    this.#memory.call('posed_vertices', this);
    return this.#memory.array(Float32Array, 0, out);
  }

  normals(out = undefined) {
    this.#memory.call('normals', this);
    return this.#memory.array(Float32Array, 0, out);
  }

  openAll() {
    this.#memory.call('open_all', this);
    return this.#memory.stats();
  }

  bounds(levels = 0) {
    this.#memory.call('bounds', this, check.count(levels, 'levels'));
    return this.#bounds();
  }

  exactBounds() {
    this.#memory.call('exact_bounds', this);
    return this.#bounds();
  }

  get nodeCount() {
    return this.#memory.call('node_count', this);
  }

  get openedNodeCount() {
    return this.#memory.call('opened_node_count', this);
  }

  nodeBoxes(level) {
    this.#memory.call('node_boxes', this, check.count(level, 'level'));
    const boxes = this.#memory.array(Float32Array, 0);
    return { count: boxes.length / 6, boxes, states: this.#memory.array(Uint8Array, 1) };
  }

  get isClosed() {
    return this.#memory.call('is_closed', this) !== 0;
  }

  cast(origin, direction, options = undefined) {
    return this.#cast('cast', origin, direction, options) ? readHits(this.#memory)[0] : null;
  }

  castAny(origin, direction, options = undefined) {
    return this.#cast('cast_any', origin, direction, options) !== 0;
  }

  castAll(origin, direction, options = undefined) {
    this.#cast('cast_all', origin, direction, options);
    return readHits(this.#memory);
  }

  classify(region) {
    return kPlacements[this.#ofRegion('classify', region)];
  }

  intersectsRegion(region) {
    return this.#ofRegion('intersects_region', region) !== 0;
  }

  findTriangles(region) {
    this.#ofRegion('find_triangles', region);
    return {
      intersecting: this.#memory.array(Uint32Array, 0),
      inside: this.#memory.array(Uint32Array, 1),
      stats: this.#memory.stats(),
    };
  }

  closestPoint(point, options = undefined) {
    const { maxDistance = Infinity } = readOptions(this.#memory, options, kClosestRules);
    const xyz = check.vector(point, 3, 'point', kMaxCoordinate);
    if (!this.#memory.call('closest_point', this, ...xyz, maxDistance)) return null;
    const [closest] = readPoints(this.#memory);
    return { ...this.#memory.fields('distance'), ...closest, stats: this.#memory.stats() };
  }

  sideOf(point) {
    const xyz = check.vector(point, 3, 'point', kMaxCoordinate);
    requireClosed(this);
    return kSides[this.#memory.call('side_of', this, ...xyz)];
  }

  delete() {
    this.#memory.handles.delete(this);
  }

  #set(what, numbers, floats, name) {
    this.#memory.call(`set_${what}`, this, check.typed(numbers, floats, name));
  }

  #bounds() {
    return { box: this.#memory.fields('low', 'high'), ...this.#memory.fields('centre', 'radius') };
  }

  /** Calls a query of a ray. */
  #cast(query, origin, direction, options) {
    const given = readOptions(this.#memory, options, kRayRules);
    const { minT = 0, maxT = Infinity, facing = 'both' } = given;
    check.vector(origin, 3, 'origin', check.kMaxFloat);
    check.vector(direction, 3, 'direction', check.kMaxFloat);
    const ray = Float32Array.of(...origin, ...direction, minT, maxT);
    return this.#memory.call(query, this, ray, kFacings.indexOf(facing));
  }

  #ofRegion(query, region) {
    return this.#memory.call(query, this, ...numbersOfRegion(this.#memory, region));
  }
}
