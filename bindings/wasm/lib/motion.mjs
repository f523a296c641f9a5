/** Queries of steps from one pose to the next. */

import * as check from './checks.mjs';
import { invalid } from './errors.mjs';
import { readObject, readOptions } from './options.mjs';
import { Pose } from './pose.mjs';
import { limit } from './queries.mjs';
import { filterOf, readLeftOut } from './self.mjs';
import { readStats } from './stats.mjs';

/** Numbered as in motion.hpp. */
export const FeatureKind = Object.freeze({ corner: 0, edge: 1, face: 2 });

const any = (value) => value;
const kMotionRules = { from: any, to: any };
const kFirstRules = { leaveOutStart: check.flag };
const kMovingRules = { leaveOutStart: check.flag, times: check.flag, maxContacts: limit };

/** Same order as in moving_columns.cpp. */
const kColumns = [
  ['times', Float32Array, 1],
  ['atStart', Uint8Array, 1],
  ['features', Uint8Array, 1],
];

function motion(memory, given, name) {
  if (given instanceof Pose) throw invalid(`${name}: expected { from, to }, found a Pose`);
  const { from, to } = readObject(memory, given, kMotionRules, name);
  const handles = [
    memory.handles.given(from, Pose, `${name}.from`),
    memory.handles.given(to, Pose, `${name}.to`),
  ];
  const isOfOne = from.character === to.character && from.part === to.part;
  if (isOfOne) return { poses: [from, to], handles };
  throw invalid(`${name}: expected two poses of one character, or of one part of a character`);
}

/** Returns the four handles. */
function motions(memory, a, b) {
  const [of, other] = [motion(memory, a, 'a'), motion(memory, b, 'b')];
  if (of.poses.some((pose) => other.poses.includes(pose))) {
    throw invalid('a and b: expected different poses, found one pose in both motions');
  }
  return [...of.handles, ...other.handles];
}

function readMovingStats(memory) {
  return {
    ...readStats(memory),
    doublePairs: memory.field('doublePairs'),
    exactPairs: memory.field('exactPairs'),
  };
}

/** Returns the options as numbers for the engine. */
export function readMovingOptions(memory, options) {
  const read = readOptions(memory, options, kMovingRules);
  const { leaveOutStart = false, times = true, maxContacts = check.kMaxCount } = read;
  return [leaveOutStart ? 1 : 0, times ? 1 : 0, maxContacts];
}

/** Reads what the last query has found about each contact beside its triangles. */
export function readMovingColumns(memory) {
  return Object.fromEntries(
    kColumns.map(([name, type, width], column) => {
      memory.module._pelt_moving_column(column);
      return [name, memory.data(type, width)];
    }),
  );
}

/** Reading the columns replaces the answer, so it comes last. */
function readMovingContacts(memory) {
  const pairs = memory.data(Uint32Array, 2);
  const stats = readMovingStats(memory);
  return { count: pairs.length / 2, pairs, ...readMovingColumns(memory), stats };
}

export function collideMoving(memory, a, b, options) {
  const read = readMovingOptions(memory, options);
  memory.module._pelt_collide_moving(...motions(memory, a, b), ...read);
  return readMovingContacts(memory);
}

export function touchWhileMoving(memory, a, b) {
  return memory.module._pelt_touch_while_moving(...motions(memory, a, b)) !== 0;
}

export function firstContact(memory, a, b, options) {
  const { leaveOutStart = false } = readOptions(memory, options, kFirstRules);
  const handles = motions(memory, a, b);
  if (!memory.module._pelt_first_contact(...handles, leaveOutStart ? 1 : 0)) return null;
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

/** Returns the handles of both poses, and that of the filter. */
function motionWith(memory, given, filter) {
  const { poses, handles } = motion(memory, given, 'motion');
  return [...handles, filterOf(memory, filter, poses[0].character, poses[0].part)];
}

export function selfCollideMoving(memory, given, filter, options) {
  const read = readMovingOptions(memory, options);
  memory.module._pelt_self_collide_moving(...motionWith(memory, given, filter), ...read);
  const leftOut = readLeftOut(memory);
  return { ...readMovingContacts(memory), leftOut };
}

export function selfTouchesWhileMoving(memory, given, filter) {
  return memory.module._pelt_self_touches_while_moving(...motionWith(memory, given, filter)) !== 0;
}
