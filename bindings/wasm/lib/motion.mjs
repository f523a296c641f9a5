/** Queries of steps from one pose to the next. */

import * as check from './checks.mjs';
import { invalid } from './errors.mjs';
import { readObject, readOptions } from './options.mjs';
import { Pose } from './pose.mjs';
import { limit } from './queries.mjs';
import { filterOf, readLeftOut } from './self.mjs';

/** Numbered as in motion.hpp. */
export const FeatureKind = Object.freeze({ corner: 0, edge: 1, face: 2 });

const any = (value) => value;
const kMotionRules = { from: any, to: any };
const kFirstRules = { leaveOutStart: check.flag };
const kMovingRules = { leaveOutStart: check.flag, times: check.flag, maxContacts: limit };

/** Same order as in moving_columns.hpp. The array before these has the triangles of the contacts. */
const kColumns = [
  ['times', Float32Array],
  ['atStart', Uint8Array],
  ['features', Uint8Array],
];

/** Returns the two poses. */
function motion(memory, given, name) {
  if (given instanceof Pose) throw invalid(`${name}: expected { from, to }, found a Pose`);
  const { from, to } = readObject(memory, given, kMotionRules, name);
  memory.handles.given(from, Pose, `${name}.from`);
  memory.handles.given(to, Pose, `${name}.to`);
  if (from.character === to.character && from.part === to.part) return [from, to];
  throw invalid(`${name}: expected two poses of one character, or of one part of a character`);
}

/** Returns the four poses. */
function motions(memory, a, b) {
  const [of, other] = [motion(memory, a, 'a'), motion(memory, b, 'b')];
  if (of.some((pose) => other.includes(pose))) {
    throw invalid('a and b: expected different poses, found one pose in both motions');
  }
  return [...of, ...other];
}

/** Returns the options as arguments of the engine. */
export function readMovingOptions(memory, options) {
  const read = readOptions(memory, options, kMovingRules);
  const { leaveOutStart = false, times = true, maxContacts = check.kMaxCount } = read;
  return [leaveOutStart, times, maxContacts];
}

/** Reads the times and features of the contacts of the last query. */
export function readMovingColumns(memory) {
  return memory.arrays(kColumns, 1);
}

function readMovingContacts(memory) {
  const pairs = memory.array(Uint32Array);
  const stats = { ...memory.stats(), ...memory.fields('doublePairs', 'exactPairs') };
  return { count: pairs.length / 2, pairs, ...readMovingColumns(memory), stats };
}

export function collideMoving(memory, a, b, options = undefined) {
  const read = readMovingOptions(memory, options);
  memory.call('collide_moving', ...motions(memory, a, b), ...read);
  return readMovingContacts(memory);
}

export function touchWhileMoving(memory, a, b) {
  return memory.call('touch_while_moving', ...motions(memory, a, b)) !== 0;
}

export function firstContact(memory, a, b, options = undefined) {
  const { leaveOutStart = false } = readOptions(memory, options, kFirstRules);
  if (!memory.call('first_contact', ...motions(memory, a, b), leaveOutStart)) return null;
  const { pairs, times, atStart, features, stats } = readMovingContacts(memory);
  return {
    triangleA: pairs[0],
    triangleB: pairs[1],
    time: times[0],
    atStart: atStart[0] !== 0,
    featureA: { kind: features[0], number: features[1] },
    featureB: { kind: features[2], number: features[3] },
    stats,
  };
}

/** Returns both poses and the filter. */
function motionWith(memory, given, filter) {
  const [from, to] = motion(memory, given, 'motion');
  return [from, to, filterOf(memory, filter, from.character, from.part)];
}

export function selfCollideMoving(memory, given, filter, options = undefined) {
  const read = readMovingOptions(memory, options);
  memory.call('self_collide_moving', ...motionWith(memory, given, filter), ...read);
  return { ...readMovingContacts(memory), leftOut: readLeftOut(memory) };
}

export function selfTouchesWhileMoving(memory, given, filter) {
  return memory.call('self_touches_while_moving', ...motionWith(memory, given, filter)) !== 0;
}
