/** Rays and their hits. */

import * as check from './checks.mjs';
import { readOptions } from './options.mjs';

/** Numbered as in ray.hpp. */
const kFacings = ['both', 'front', 'back'];

const kRules = {
  minT: (value, name) => check.number(value, name, -Infinity, Infinity),
  maxT: (value, name) => check.number(value, name, -Infinity, Infinity),
  facing: (value, name) => check.oneOf(value, kFacings, name),
};

/** Passes a ray to the engine. Returns the number of its facing. */
function writeRay(memory, origin, direction, options) {
  const { minT = 0, maxT = Infinity, facing = 'both' } = readOptions(memory, options, kRules);
  check.vector(origin, 3, 'origin', check.kMaxFloat);
  check.vector(direction, 3, 'direction', check.kMaxFloat);
  const numbers = [...origin, ...direction, minT, maxT];
  memory.write(Float32Array, memory.module._pelt_ray(), numbers, 8, 'ray');
  return kFacings.indexOf(facing);
}

function readHits(memory) {
  const rows = memory.data(Float64Array, 1);
  const hits = [];
  for (let i = 0; i < rows.length; i += 8) {
    const [triangle, t, ...rest] = rows.subarray(i, i + 8);
    hits.push({ triangle, t, weights: rest.slice(0, 3), normal: rest.slice(3) });
  }
  return hits;
}

/** `pose` is a handle, here and below. */
export function cast(memory, pose, origin, direction, options) {
  const facing = writeRay(memory, origin, direction, options);
  return memory.module._pelt_cast(pose, facing) ? readHits(memory)[0] : null;
}

export function castAny(memory, pose, origin, direction, options) {
  const facing = writeRay(memory, origin, direction, options);
  return memory.module._pelt_cast_any(pose, facing) !== 0;
}

export function castAll(memory, pose, origin, direction, options) {
  memory.module._pelt_cast_all(pose, writeRay(memory, origin, direction, options));
  return readHits(memory);
}
