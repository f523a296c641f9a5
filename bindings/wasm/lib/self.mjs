/** Contacts of a pose with itself, and their filters. */

import * as check from './checks.mjs';
import { invalid } from './errors.mjs';
import { partNumber } from './lookup.mjs';
import { readOptions } from './options.mjs';
import { Pose } from './pose.mjs';
import { mostContacts, readContacts } from './queries.mjs';

const rowsOf = (type, width) => (value, name) => check.rows(value, width, name, type);

/** Same order as in self.cpp. */
const kArrays = [
  ['takesPart', Uint8Array, 1],
  ['atRest', Uint32Array, 2],
  ['always', Uint32Array, 2],
  ['jointPairs', Uint16Array, 2],
  ['groups', Uint16Array, 1],
  ['groupPairs', Uint16Array, 2],
];

const kFilterRules = {
  rings: (rings, name) => check.count(rings, name, 0, 64),
  nearJoints: check.flag,
  ...Object.fromEntries(kArrays.map(([name, type, width]) => [name, rowsOf(type, width)])),
};

function checkRange(numbers, name, count) {
  numbers?.forEach((number, i) => check.count(number, `${name}[${i}]`, 0, count - 1));
}

/** Checks what depends on the character. */
function checkFilter(options, character, part) {
  const { triangleCount } = part === null ? character : character.parts[part];
  for (const name of ['takesPart', 'groups']) {
    if (options[name] !== undefined) check.numbers(options[name], triangleCount, name);
  }
  for (const name of ['atRest', 'always']) {
    checkRange(options[name], name, character.triangleCount);
  }
  checkRange(options.jointPairs, 'jointPairs', character.jointCount);
  if (options.groupPairs?.length > 0 && options.groups === undefined) {
    throw invalid('groupPairs: needs the option groups');
  }
}

export class SelfFilter {
  #memory;

  constructor(memory, character, options, part) {
    this.#memory = memory;
    const read = readOptions(memory, options, kFilterRules);
    const number = partNumber(character, part);
    checkFilter(read, character, part);
    const { rings = 0, nearJoints = false } = read;
    const arrays = kArrays.map(([name, type]) => read[name] ?? new type());
    const made = memory.call('make_self_filter', character, number, rings, nearJoints, ...arrays);
    memory.handles.own(this, made, 'delete_self_filter', `self filter of ${character.name}`);
    this.character = character;
    this.part = part;
    Object.freeze(this);
  }

  delete() {
    this.#memory.handles.delete(this);
  }
}

/** Checks a filter, which must be of a character, or of a part of it. Returns it. */
export function filterOf(memory, filter, character, part) {
  memory.handles.given(filter, SelfFilter, 'filter');
  if (filter.character === character && filter.part === part) return filter;
  throw invalid('filter: it was made for another character or part');
}

function posedWith(memory, pose, filter) {
  memory.handles.given(pose, Pose, 'pose');
  return [pose, filterOf(memory, filter, pose.character, pose.part)];
}

export function readLeftOut(memory) {
  const [takesPart, rings, atRest, always, joints, groups] = memory.field('leftOut');
  return { takesPart, rings, atRest, always, joints, groups };
}

export function selfCollide(memory, pose, filter, options = undefined) {
  const most = mostContacts(memory, options);
  memory.call('self_collide', ...posedWith(memory, pose, filter), most);
  return { ...readContacts(memory), leftOut: readLeftOut(memory) };
}

export function selfIntersects(memory, pose, filter) {
  return memory.call('self_intersects', ...posedWith(memory, pose, filter)) !== 0;
}

/** Checks that pairs ascend without repetition, as `selfCollide` returns them. */
function checkAscending(pairs) {
  for (let i = 2; i < pairs.length; i += 2) {
    if (pairs[i - 2] < pairs[i] || (pairs[i - 2] === pairs[i] && pairs[i - 1] < pairs[i + 1])) continue;
    throw invalid(`pairs: pair ${i / 2} is not greater than the pair before it`);
  }
}

export class ContactTally {
  #memory;

  constructor(memory) {
    this.#memory = memory;
    memory.handles.own(this, memory.call('make_tally'), 'delete_tally', 'tally');
  }

  add(pairs) {
    checkAscending(check.rows(pairs, 2, 'pairs'));
    this.#memory.call('tally_add', this, pairs);
  }

  get poseCount() {
    return this.#memory.call('tally_pose_count', this);
  }

  inShareOfPoses(share) {
    this.#memory.call('tally_in_share', this, check.number(share, 'share', 0, 1));
    return this.#memory.array(Uint32Array);
  }

  delete() {
    this.#memory.handles.delete(this);
  }
}
