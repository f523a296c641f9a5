/** Queries of two poses. */

import * as check from './checks.mjs';
import { invalid } from './errors.mjs';
import { readOptions } from './options.mjs';
import { Pose, readPoints, requireClosed } from './pose.mjs';

export const ContactKind = Object.freeze({ segment: 0, point: 1, coplanar: 2, collapsed: 3 });

export const limit = (most, name) => (most === Infinity ? check.kMaxCount : check.count(most, name, 1));
const kCollideRules = { firstContact: check.flag, maxContacts: limit };
const length = (value, name) => check.number(value, name, 0, Infinity);
const kClearanceRules = { firstPair: check.flag, maxPairs: limit };
const kDistanceRules = { maxDistance: length, tolerance: length };

/** Numbered as in inside.hpp. */
const kContainments = ['none', 'a_in_b', 'b_in_a'];

export function mostContacts(memory, options) {
  const read = readOptions(memory, options, kCollideRules);
  return read.firstContact ? 1 : read.maxContacts ?? check.kMaxCount;
}

/** Checks the two poses, and returns them. */
export function different(memory, a, b) {
  const poses = [memory.handles.given(a, Pose, 'a'), memory.handles.given(b, Pose, 'b')];
  if (a === b) throw invalid('a and b: expected two different poses');
  return poses;
}

export function readContacts(memory) {
  const pairs = memory.array(Uint32Array);
  return { count: pairs.length / 2, pairs, stats: memory.stats() };
}

export function collide(memory, a, b, options = undefined) {
  const most = mostContacts(memory, options);
  memory.call('collide', ...different(memory, a, b), most);
  return readContacts(memory);
}

export function collideEagerly(memory, a, b, options = undefined) {
  const most = mostContacts(memory, options);
  memory.call('collide_eagerly', ...different(memory, a, b), most);
  return readContacts(memory);
}

export function intersects(memory, a, b) {
  return memory.call('intersects', ...different(memory, a, b)) !== 0;
}

/** Finds the pairs within a tolerance. */
export function clearance(memory, a, b, tolerance, options = undefined) {
  const read = readOptions(memory, options, kClearanceRules);
  const most = read.firstPair ? 1 : read.maxPairs ?? check.kMaxCount;
  const poses = different(memory, a, b);
  memory.call('clearance', ...poses, length(tolerance, 'tolerance'), most);
  return readContacts(memory);
}

export function isWithin(memory, a, b, tolerance) {
  const poses = different(memory, a, b);
  return memory.call('is_within', ...poses, length(tolerance, 'tolerance')) !== 0;
}

export function distance(memory, a, b, options = undefined) {
  const poses = different(memory, a, b);
  const read = readOptions(memory, options, kDistanceRules);
  const { maxDistance = Infinity, tolerance = 0 } = read;
  if (!memory.call('distance', ...poses, maxDistance, tolerance)) return null;
  const [pointA, pointB] = readPoints(memory);
  const distances = memory.fields('distance', 'lowerBound');
  return { ...distances, a: pointA, b: pointB, stats: memory.stats() };
}

export function deepestVertex(memory, a, b) {
  const poses = different(memory, a, b);
  requireClosed(b);
  if (!memory.call('deepest_vertex', ...poses)) return null;
  const [closest] = readPoints(memory);
  return { ...memory.fields('vertex', 'position', 'depth'), closest, stats: memory.stats() };
}

export function containment(memory, a, b) {
  return kContainments[memory.call('containment', ...different(memory, a, b))];
}

/** Same order as in contacts.cpp. */
const kColumns = [
  ['segments', Float32Array],
  ['normals', Float32Array],
  ['depths', Float32Array],
  ['kinds', Uint8Array],
  ['joints', Uint16Array],
  ['points', Float32Array],
  ['curves', Uint32Array],
  ['patches', Float64Array],
  ['members', Uint32Array],
];

function describe(memory, poses, pairs) {
  memory.call('describe_contacts', ...poses, check.rows(pairs, 2, 'pairs'));
  const { points, curves, patches, members, ...columns } = memory.arrays(kColumns);
  return {
    ...columns,
    curves: readCurves(curves, points),
    patches: readPatches(patches, members),
  };
}

export function describeContacts(memory, a, b, pairs) {
  return describe(memory, different(memory, a, b), pairs);
}

export function describeSelfContacts(memory, pose, pairs) {
  memory.handles.given(pose, Pose, 'pose');
  return describe(memory, [pose, pose], pairs);
}

function readCurves(rows, points) {
  const curves = [];
  for (let i = 0; i < rows.length; i += 3) {
    const [begin, end, closed] = rows.subarray(i, i + 3);
    curves.push({ isClosed: closed !== 0, points: points.slice(3 * begin, 3 * end) });
  }
  return curves;
}

function readPatches(rows, members) {
  const patches = [];
  for (let i = 0; i < rows.length; i += 12) {
    const [begin, end, length, depth, ...rest] = rows.subarray(i, i + 12);
    patches.push({
      contacts: members.slice(begin, end),
      length,
      depth,
      point: rest.slice(0, 3),
      normal: rest.slice(3, 6),
      jointA: rest[6],
      jointB: rest[7],
    });
  }
  return patches;
}
