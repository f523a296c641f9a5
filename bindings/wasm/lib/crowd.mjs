import { Character } from './character.mjs';
import * as check from './checks.mjs';
import { invalid } from './errors.mjs';
import { partNumber } from './lookup.mjs';
import { readMovingColumns, readMovingOptions } from './motion.mjs';
import { mostContacts } from './queries.mjs';
import { filterOf, readLeftOut, SelfFilter } from './self.mjs';

export class Crowd {
  #memory;
  #members = [];
  #ignores = false;

  constructor(memory) {
    this.#memory = memory;
    memory.handles.own(this, memory.call('make_crowd'), 'delete_crowd', 'crowd');
  }

  add(character, part = null) {
    this.#memory.handles.given(character, Character, 'character');
    const named = partNumber(character, part);
    const number = this.#memory.call('add_to_crowd', this, character, named);
    this.#members[number] = { character, part };
    return number;
  }

  setPalette(instance, palette) {
    this.#set(instance, 'palette', palette, ({ jointCount }) => 16 * jointCount, 'palette');
  }

  setDualQuaternions(instance, numbers) {
    const floats = ({ jointCount }) => 8 * jointCount;
    this.#set(instance, 'dual_quaternions', numbers, floats, 'dualQuaternions');
  }

  setMorphWeights(instance, weights) {
    const floats = ({ morphTargetNames }) => morphTargetNames.length;
    this.#set(instance, 'morph_weights', weights, floats, 'weights');
  }

  setVertices(instance, vertices) {
    this.#set(instance, 'vertices', vertices, ({ vertexCount }) => 3 * vertexCount, 'vertices');
  }

  setOffsets(instance, offsets) {
    const floats = ({ vertexCount }) => (offsets === null ? 0 : 3 * vertexCount);
    this.#set(instance, 'offsets', offsets === null ? [] : offsets, floats, 'offsets');
  }

  setSelfFilter(instance, filter) {
    const { character, part } = this.#member(instance);
    if (filter !== null) filterOf(this.#memory, filter, character, part);
    this.#memory.call('set_crowd_self_filter', this, instance, filter);
  }

  filterParts(instances, filter) {
    if (!Array.isArray(instances)) throw invalid('instances: expected an array');
    this.#memory.handles.given(filter, SelfFilter, 'filter');
    instances.forEach((instance, i) => {
      const { character, part } = this.#member(instance);
      filterOf(this.#memory, filter, character, null);
      if (part === null) throw invalid(`instances[${i}]: expected a part, found a whole character`);
    });
    const number = this.#memory.call('add_crowd_part_filter', this, filter);
    for (const instance of instances) {
      this.#memory.call('set_crowd_part_filter', this, instance, number);
    }
  }

  ignore(pairs) {
    const names = JSON.stringify(check.namePairs(pairs, 'ignore'));
    this.#memory.call('ignore_in_crowd', this, names);
    this.#ignores = pairs.length > 0;
  }

  collide(options = undefined) {
    const most = mostContacts(this.#memory, options);
    this.#checkLimit(most);
    this.#memory.call('collide_crowd', this, most);
    return this.#readContacts();
  }

  beginStep() {
    this.#memory.call('begin_crowd_step', this);
  }

  setMotion(instance, from, to) {
    this.#setMotion(instance, 'motion', from, to, 16);
  }

  setMotionDualQuaternions(instance, from, to) {
    this.#setMotion(instance, 'motion_dual_quaternions', from, to, 8);
  }

  collideMoving(options = undefined) {
    const read = readMovingOptions(this.#memory, options);
    this.#checkLimit(read.at(-1));
    this.#memory.call('collide_crowd_moving', this, ...read);
    const { count, contacts, ...rest } = this.#readContacts();
    return { count, contacts, ...readMovingColumns(this.#memory), ...rest };
  }

  withoutIgnored(contacts) {
    check.rows(contacts, 4, 'contacts').forEach((number, i) => this.#checkNumber(contacts, number, i));
    this.#memory.call('without_ignored', this, contacts);
    return { contacts: this.#memory.array(Uint32Array), ...this.#memory.fields('ignored') };
  }

  delete() {
    this.#memory.handles.delete(this);
  }

  #checkLimit(most) {
    if (!this.#ignores || most === check.kMaxCount) return;
    throw invalid(
      'a limit: cannot be combined with ignored pairs, because the first contacts may be ignored',
    );
  }

  #readContacts() {
    const contacts = this.#memory.array(Uint32Array);
    return {
      count: contacts.length / 4,
      contacts,
      ...this.#memory.fields('ignored'),
      leftOut: readLeftOut(this.#memory),
      stats: this.#memory.stats(),
    };
  }

  /** Checks an instance, or a triangle of the instance two numbers before. */
  #checkNumber(contacts, number, i) {
    if (i % 4 < 2) return this.#member(number);
    const { triangleCount } = this.#member(contacts[i - 2]).character;
    return check.count(number, `contacts[${i}]`, 0, triangleCount - 1);
  }

  #member(instance) {
    const member = this.#members[check.count(instance, 'instance')];
    if (member !== undefined) return member;
    throw invalid(`instance: the crowd has no instance ${instance}`);
  }

  #set(instance, what, numbers, floatsOf, name) {
    const floats = floatsOf(this.#member(instance).character);
    const typed = check.typed(numbers, floats, name);
    this.#memory.call(`set_crowd_${what}`, this, instance, typed);
  }

  /** Both palettes have `width` floats per joint. */
  #setMotion(instance, what, from, to, width) {
    const floats = width * this.#member(instance).character.jointCount;
    const ends = [check.typed(from, floats, 'from'), check.typed(to, floats, 'to')];
    this.#memory.call(`set_crowd_${what}`, this, instance, ...ends);
  }
}

export class ContactHash {
  #memory;

  constructor(memory) {
    this.#memory = memory;
    memory.handles.own(this, memory.call('make_hash'), 'delete_hash', 'hash');
  }

  add(frame, a, b, pairs) {
    const before = [check.count(frame, 'frame'), check.count(a, 'a'), check.count(b, 'b')];
    this.#memory.call('hash_pairs', this, ...before, check.rows(pairs, 2, 'pairs'));
  }

  addCrowd(frame, contacts) {
    check.count(frame, 'frame');
    this.#memory.call('hash_crowd', this, frame, check.rows(contacts, 4, 'contacts'));
  }

  get value() {
    this.#memory.call('hash_value', this);
    const hex = (number) => number.toString(16).padStart(8, '0');
    return hex(this.#memory.field('hashHigh')) + hex(this.#memory.field('hashLow'));
  }

  delete() {
    this.#memory.handles.delete(this);
  }
}
