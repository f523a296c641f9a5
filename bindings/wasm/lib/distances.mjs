/** Distances of surfaces from points and from each other, and depths inside. */

import * as check from './checks.mjs';
import { invalid } from './errors.mjs';
import { readOptions } from './options.mjs';
import { readStats } from './stats.mjs';

/** Numbered as in inside.hpp. */
const kSides = ['outside', 'on', 'inside'];
const kContainments = ['none', 'a_in_b', 'b_in_a'];

/** Largest coordinate that queries accept. */
const kMaxCoordinate = 2 ** 60;

const length = (value, name) => check.number(value, name, 0, Infinity);
const kClosestRules = { maxDistance: length };
const kDistanceRules = { maxDistance: length, tolerance: length };

/** Uses the layout of surface_points.cpp. */
function readPoints(memory) {
  const rows = memory.data(Float64Array, 1);
  const points = [];
  for (let i = 0; i < rows.length; i += 7) {
    const [triangle, ...rest] = rows.subarray(i, i + 7);
    points.push({ triangle, position: rest.slice(0, 3), weights: rest.slice(3) });
  }
  return points;
}

/** `pose` is a handle. */
export function closestPoint(memory, pose, point, options) {
  const { maxDistance = Infinity } = readOptions(memory, options, kClosestRules);
  const [x, y, z] = check.vector(point, 3, 'point', kMaxCoordinate);
  if (!memory.module._pelt_closest_point(pose, x, y, z, maxDistance)) return null;
  const [closest] = readPoints(memory);
  return { distance: memory.field('distance'), ...closest, stats: readStats(memory) };
}

export function distance(memory, [a, b], options) {
  const read = readOptions(memory, options, kDistanceRules);
  const { maxDistance = Infinity, tolerance = 0 } = read;
  if (!memory.module._pelt_distance(a, b, maxDistance, tolerance)) return null;
  const [pointA, pointB] = readPoints(memory);
  return {
    distance: memory.field('distance'),
    lowerBound: memory.field('lowerBound'),
    a: pointA,
    b: pointB,
    stats: readStats(memory),
  };
}

/** `pose` is the object here. */
function requireClosed(pose) {
  if (!pose.isClosed) {
    throw invalid(`the surface of ${pose.character.name} is not closed: it has no inside`);
  }
}

export function sideOf(memory, handle, pose, point) {
  const [x, y, z] = check.vector(point, 3, 'point', kMaxCoordinate);
  requireClosed(pose);
  return kSides[memory.module._pelt_side_of(handle, x, y, z)];
}

/** `pose` is the second one. */
export function deepestVertex(memory, [a, b], pose) {
  requireClosed(pose);
  if (!memory.module._pelt_deepest_vertex(a, b)) return null;
  const [closest] = readPoints(memory);
  return {
    vertex: memory.field('vertex'),
    position: memory.field('position'),
    depth: memory.field('depth'),
    closest,
    stats: readStats(memory),
  };
}

export function containment(memory, [a, b]) {
  return kContainments[memory.module._pelt_containment(a, b)];
}
