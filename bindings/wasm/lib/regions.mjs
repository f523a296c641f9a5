/** Regions of space. */

import * as check from './checks.mjs';
import { invalid } from './errors.mjs';
import { readObject } from './options.mjs';

/** Numbered as in solid.hpp. */
export const kPlacements = ['outside', 'partly', 'inside'];

/** Largest number of faces of a polyhedron. */
const kMaxFaces = 64;

const { float } = check;
const vector = (value, name) => Array.from(check.vector(value, 3, name, check.kMaxFloat));
/** Faces of a frustum are sums of two elements, and must be finite. */
const matrix = (value, name) => Array.from(check.vector(value, 16, name, check.kMaxFloat / 2));
const size = (value, name) => check.number(value, name, 0, check.kMaxFloat);
const sizes = (value, name) => vector(value, name).map((x, axis) => size(x, `${name}[${axis}]`));

function list(value, name, least, most) {
  if (Array.isArray(value) && value.length >= least && value.length <= most) return value;
  const found = Array.isArray(value) ? `${value.length}` : check.kindOf(value);
  const expected = least === most ? `${most}` : `up to ${most}`;
  throw invalid(`${name}: expected an array of ${expected}, found ${found}`);
}

const kFaceRules = { normal: vector, offset: float };
const kDepths = { minusOneToOne: 6, zeroToOne: 7 };
const kUnitAxes = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];

function axes(value, name) {
  return list(value, name, 3, 3).map((axis, i) => vector(axis, `${name}[${i}]`));
}

/** Kinds of regions in the order of rays_and_regions.cpp, with functions that list their numbers. */
const kKinds = {
  halfSpace: {
    rules: kFaceRules,
    write: ({ normal, offset }) => [0, normal, offset],
  },
  box: {
    rules: { low: vector, high: vector },
    write: ({ low, high }) => [1, low, high],
  },
  orientedBox: {
    rules: { centre: vector, axes, half: sizes },
    defaults: { axes: kUnitAxes },
    write: ({ centre, axes, half }) => [2, centre, axes, half],
  },
  polyhedron: {
    rules: { faces: (faces, name) => list(faces, name, 0, kMaxFaces) },
    write: ({ faces }) => [3, faces.map(({ normal, offset }) => [normal, offset])],
  },
  sphere: {
    rules: { centre: vector, radius: size },
    write: ({ centre, radius }) => [4, centre, radius],
  },
  capsule: {
    rules: { a: vector, b: vector, radius: size },
    write: ({ a, b, radius }) => [5, a, b, radius],
  },
  frustum: {
    rules: {
      viewProjection: matrix,
      depth: (value, name) => check.oneOf(value, Object.keys(kDepths), name),
    },
    defaults: { depth: 'minusOneToOne' },
    write: ({ viewProjection, depth }) => [kDepths[depth], viewProjection],
  },
};

/** Returns the values of `given`. Throws if one is missing. */
function complete(memory, given, { rules, defaults = {} }, place) {
  const values = { ...defaults, ...readObject(memory, given, rules, place) };
  for (const key of Object.keys(rules)) {
    if (values[key] === undefined)
      throw invalid(`${place}.${key}: expected a value, found nothing`);
  }
  return values;
}

/** Returns the number of a kind of region, and the numbers of the region. */
export function numbersOfRegion(memory, region) {
  const { kind, ...given } = check.object(region, 'region');
  check.oneOf(kind, Object.keys(kKinds), 'region.kind');
  const values = complete(memory, given, kKinds[kind], 'region');
  if (kind === 'polyhedron') {
    values.faces = values.faces.map((face, i) =>
      complete(memory, face, { rules: kFaceRules }, `region.faces[${i}]`),
    );
  }
  const [number, ...numbers] = kKinds[kind].write(values).flat(Infinity);
  return [number, Float32Array.from(check.numbers(numbers, numbers.length, 'region'))];
}
