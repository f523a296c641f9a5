/** Queries of two poses. */

import * as check from './checks.mjs';
import { invalid } from './errors.mjs';
import { readOptions } from './options.mjs';
import { Pose } from './pose.mjs';
import { readStats } from './stats.mjs';

export const ContactKind = Object.freeze({ segment: 0, point: 1, coplanar: 2, collapsed: 3 });

export const limit = (most, name) => (most === Infinity ? check.kMaxCount : check.count(most, name, 1));
const kCollideRules = { firstContact: check.flag, maxContacts: limit };
const kClearanceRules = { firstPair: check.flag, maxPairs: limit };

export function mostContacts(memory, options) {
  const read = readOptions(memory, options, kCollideRules);
  return read.firstContact ? 1 : read.maxContacts ?? check.kMaxCount;
}

/** Returns the two handles. */
export function different(memory, a, b) {
  const handles = [memory.handles.given(a, Pose, 'a'), memory.handles.given(b, Pose, 'b')];
  if (a === b) throw invalid('a and b: expected two different poses');
  return handles;
}

export function readContacts(memory) {
  const pairs = memory.data(Uint32Array, 2);
  return { count: pairs.length / 2, pairs, stats: readStats(memory) };
}

/** Finds the pairs within a tolerance. */
export function clearance(memory, a, b, tolerance, options) {
  const read = readOptions(memory, options, kClearanceRules);
  const most = read.firstPair ? 1 : read.maxPairs ?? check.kMaxCount;
  const handles = different(memory, a, b);
  check.number(tolerance, 'tolerance', 0, Infinity);
  memory.module._pelt_clearance(...handles, tolerance, most);
  return readContacts(memory);
}

export function isWithin(memory, a, b, tolerance) {
  const handles = different(memory, a, b);
  check.number(tolerance, 'tolerance', 0, Infinity);
  return memory.module._pelt_is_within(...handles, tolerance) !== 0;
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

function readColumns(memory) {
  return Object.fromEntries(
    kColumns.map(([name, type], column) => {
      memory.module._pelt_contact_column(column);
      return [name, memory.data(type, 1)];
    }),
  );
}

export function describeContacts(memory, handles, pairs) {
  memory.withBytes(check.rows(pairs, 2, 'pairs'), (address) =>
    memory.accepted(memory.module._pelt_describe_contacts(...handles, address, pairs.length / 2)),
  );
  const { points, curves, patches, members, ...columns } = readColumns(memory);
  return {
    ...columns,
    curves: readCurves(curves, points),
    patches: readPatches(patches, members),
  };
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
