/** Validation of arguments. Errors name the argument. */

import { invalid } from './errors.mjs';

export const kMaxCount = 0xffffffff;

/** Largest number in the engine's single precision; larger numbers would be infinite. */
export const kMaxFloat = (2 - 2 ** -23) * 2 ** 127;

/** Describes a value in messages: "NaN", "a string", "an Array". */
export function kindOf(value) {
  if (value === undefined) return 'nothing';
  if (value === null || typeof value === 'number' || typeof value === 'boolean') return `${value}`;
  const kind = typeof value === 'object' ? value.constructor?.name || 'object' : typeof value;
  return `${/^[aeiou]/i.test(kind) ? 'an' : 'a'} ${kind}`;
}

function refuse(name, expected, value) {
  throw invalid(`${name}: expected ${expected}, found ${kindOf(value)}`);
}

function isWithin(value, least, most) {
  return typeof value === 'number' && value >= least && value <= most;
}

export function number(value, name, least = -Number.MAX_VALUE, most = Number.MAX_VALUE) {
  if (isWithin(value, least, most)) return value;
  const isAny = least === -most && most >= kMaxFloat && most < Infinity;
  return refuse(name, isAny ? 'a finite number' : `a number from ${least} to ${most}`, value);
}

export function float(value, name) {
  return number(value, name, -kMaxFloat, kMaxFloat);
}

export function count(value, name, least = 0, most = kMaxCount) {
  if (Number.isInteger(value) && isWithin(value, least, most)) return value;
  return refuse(name, `a whole number from ${least} to ${most}`, value);
}

export function flag(value, name) {
  return typeof value === 'boolean' ? value : refuse(name, 'true or false', value);
}

export function text(value, name) {
  return typeof value === 'string' ? value : refuse(name, 'a string', value);
}

export function oneOf(value, known, name) {
  if (known.includes(value)) return value;
  const names = known.map((name) => JSON.stringify(name)).join(', ');
  const found = typeof value === 'string' ? JSON.stringify(value) : kindOf(value);
  throw invalid(`${name}: expected one of ${names}, found ${found}`);
}

/** Rejects zeros, which would end a path in C++. */
export function path(value, name) {
  if (text(value, name).includes('\0')) throw invalid(`${name}: a path has no character 0`);
  return value;
}

export function texts(value, name) {
  if (!Array.isArray(value)) refuse(name, 'an array of strings', value);
  return Array.from(value, (element, i) => text(element, `${name}[${i}]`));
}

export function namePairs(value, name) {
  const isPair = (pair) =>
    Array.isArray(pair) && pair.length === 2 && pair.every((part) => typeof part === 'string');
  if (Array.isArray(value) && value.every(isPair)) return value;
  throw invalid(`${name}: expected an array of pairs of names`);
}

/** Returns null if there is none. */
export function optionalText(value, name) {
  return value === null ? null : text(value, name);
}

export function callable(value, name) {
  return typeof value === 'function' ? value : refuse(name, 'a function', value);
}

function isArrayOfNumbers(value) {
  if (Array.isArray(value)) return value.every((element) => typeof element === 'number');
  return ArrayBuffer.isView(value) && (value.length === 0 || typeof value[0] === 'number');
}

/** Checks for an Array or typed array with `length` numbers, which may be NaN. */
export function numbers(value, length, name) {
  if (!isArrayOfNumbers(value)) refuse(name, `an array of ${length} numbers`, value);
  if (value.length === length) return value;
  throw invalid(`${name}: expected ${length} numbers, found ${value.length}`);
}

/** Checks like `numbers`, and returns the numbers as a `type`. */
export function typed(value, length, name, type = Float32Array) {
  const checked = numbers(value, length, name);
  return checked instanceof type ? checked : type.from(checked);
}

/** Checks for finite numbers only. */
export function vector(value, length, name, most = Number.MAX_VALUE) {
  numbers(value, length, name);
  for (let i = 0; i < length; ++i) {
    if (!isWithin(value[i], -most, most)) number(value[i], `${name}[${i}]`, -most, most);
  }
  return value;
}

/** Checks indices, such as those of triangles or instances, in rows of `width`. */
export function rows(value, width, name, type = Uint32Array) {
  if (!(value instanceof type)) refuse(name, `a ${type.name}`, value);
  if (value.length % width === 0) return value;
  throw invalid(`${name}: expected a multiple of ${width} numbers, found ${value.length}`);
}

/** Returns the bytes of an ArrayBuffer or of a view of one. */
export function bytes(value, name) {
  if (value instanceof Uint8Array) return value;
  if (ArrayBuffer.isView(value)) return new Uint8Array(value.buffer, value.byteOffset, value.byteLength);
  if (value instanceof ArrayBuffer) return new Uint8Array(value);
  return refuse(name, 'a Uint8Array or an ArrayBuffer', value);
}

/** Checks for a plain object, which excludes arrays and maps. */
export function object(value, name) {
  return Object.prototype.toString.call(value) === '[object Object]'
    ? value
    : refuse(name, 'an object', value);
}
