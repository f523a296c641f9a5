/** What is asked of two poses. */

import { invalid } from './memory.mjs';

const kAll = 0xffffffff;

export const ContactKind = Object.freeze({ segment: 0, point: 1, coplanar: 2, collapsed: 3 });

export function mostContacts({ firstContact = false, maxContacts = kAll } = {}) {
  return firstContact ? 1 : maxContacts;
}

export function readStats(memory) {
  const [nodePairs, refits, posedVertices, trianglePairs, displacements, cutShort] =
    memory.numbers(0, 6);
  return {
    nodePairs,
    refits,
    posedVertices,
    trianglePairs,
    displacements,
    cutShort: cutShort !== 0,
  };
}

/** The two handles. */
export function different(a, b) {
  if (a === b) throw invalid('a and b: expected two different poses');
  return [a.handle, b.handle];
}

export function readContacts(memory) {
  const pairs = memory.data(Uint32Array, 2);
  return { count: pairs.length / 2, pairs, stats: readStats(memory) };
}

export function describeContacts(memory, a, b, pairs) {
  const { module } = memory;
  const handles = different(a, b);
  const bytes = new Uint8Array(pairs.buffer, pairs.byteOffset, pairs.byteLength);
  memory.withBytes(bytes, (address) =>
    memory.accepted(module._pelt_describe_contacts(...handles, address, pairs.length >> 1)),
  );
  const column = (number, type) => {
    module._pelt_contact_column(number);
    return memory.data(type, 1);
  };
  return {
    segments: column(0, Float32Array),
    normals: column(2, Float32Array),
    depths: column(3, Float32Array),
    kinds: column(1, Uint8Array),
    joints: column(4, Uint16Array),
    curves: readCurves(column(6, Uint32Array), column(5, Float32Array)),
    regions: readRegions(column(7, Float64Array), column(8, Uint32Array)),
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

function readRegions(rows, members) {
  const regions = [];
  for (let i = 0; i < rows.length; i += 12) {
    const [begin, end, length, depth, ...rest] = rows.subarray(i, i + 12);
    regions.push({
      contacts: members.slice(begin, end),
      length,
      depth,
      point: rest.slice(0, 3),
      normal: rest.slice(3, 6),
      jointA: rest[6],
      jointB: rest[7],
    });
  }
  return regions;
}

export function distance(memory, a, b, { maxDistance = Infinity } = {}) {
  if (!memory.module._pelt_distance(...different(a, b), maxDistance)) return null;
  const point = (i) => ({ triangle: memory.number(i), position: memory.numbers(i + 1, i + 4) });
  return { distance: memory.number(6), a: point(7), b: point(11), stats: readStats(memory) };
}
