/** Validation of options: keys must be known and values must have the right type. */

import * as check from './checks.mjs';
import { invalid } from './errors.mjs';

/**
 * Returns the values by their keys, without undefined values. `rules` has a function for each known key,
 * which checks the value. `place` names the object in messages, and is empty for options.
 */
export function readObject(memory, given, rules, place = '') {
  const values = {};
  const known = Object.keys(rules);
  for (const [key, value] of Object.entries(check.object(given, place || 'options'))) {
    if (!known.includes(key)) throw unknown(memory, key, known, place);
    if (value !== undefined) values[key] = rules[key](value, place ? `${place}.${key}` : key);
  }
  return values;
}

function unknown(memory, key, known, place) {
  const what = place ? `${place}: unknown key` : 'unknown option';
  return invalid(`${what} ${JSON.stringify(key)}${memory.suggestion(key, known)}`);
}

/** Reads options, which may be absent. */
export function readOptions(memory, options, rules) {
  return options === undefined ? {} : readObject(memory, options, rules);
}

/** One cap for all vertices, or the caps of the vertices. */
function offsetCaps(value, name) {
  if (typeof value === 'number') return check.number(value, name, 0, 2 ** 60);
  return check.rows(value, 1, name, Float32Array);
}

const skinning = (value, name) => check.oneOf(value, ['linear', 'dual-quaternion'], name);

export const kModelRules = {
  meshoptDecode: check.callable,
  renormalise: check.flag,
  weld: check.flag,
  skinning,
  noUnskinned: check.flag,
  exclude: check.texts,
  samples: check.count,
};

export const kReadRules = {
  ...kModelRules,
  name: check.text,
  files: (files) => files,
  clips: check.texts,
  offsetCaps,
};

export const kFaceRules = {
  name: check.text,
  clips: check.texts,
  samples: check.count,
  weld: check.flag,
  skinning,
  offsetCaps,
  triangles: check.count,
  seed: check.count,
};

/** The arrays are checked when they are passed on. */
export const kMeshRules = {
  name: check.text,
  restPositions: (positions) => positions,
  triangles: (triangles) => triangles,
  weld: check.flag,
  offsetCaps,
};

export const kCreatureRules = { ...kFaceRules, joints: check.count };
