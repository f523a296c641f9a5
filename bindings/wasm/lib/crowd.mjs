import { Character } from './character.mjs';
import * as check from './checks.mjs';
import { invalid } from './errors.mjs';
import { partNumber } from './lookup.mjs';
import { readMovingColumns, readMovingOptions } from './motion.mjs';
import { mostContacts } from './queries.mjs';
import { filterOf, readLeftOut, SelfFilter } from './self.mjs';
import { readStats } from './stats.mjs';

export class Crowd {
  #memory;
  #members = [];
  #ignores = false;

  constructor(memory) {
    this.#memory = memory;
    memory.handles.own(this, memory.module._pelt_make_crowd(), '_pelt_delete_crowd', 'crowd');
  }

  add(character, part = null) {
    const { module, handles } = this.#memory;
    const given = handles.given(character, Character, 'character');
    const named = partNumber(character, part);
    this.#memory.accepted(module._pelt_add_to_crowd(this.#handle, given, named));
    const number = this.#memory.field('instance');
    this.#members[number] = { character, part };
    return number;
  }

  setPalette(instance, palette) {
    const floats = 16 * this.#member(instance).character.jointCount;
    this.#write(palette, floats, 'palette');
    const { module } = this.#memory;
    this.#memory.accepted(module._pelt_set_crowd_palette(this.#handle, instance));
  }

  setDualQuaternions(instance, dualQuaternions) {
    const floats = 8 * this.#member(instance).character.jointCount;
    this.#write(dualQuaternions, floats, 'dualQuaternions');
    const { module } = this.#memory;
    this.#memory.accepted(module._pelt_set_crowd_dual_quaternions(this.#handle, instance));
  }

  setMorphWeights(instance, weights) {
    const { character } = this.#member(instance);
    this.#write(weights, character.morphTargetNames.length, 'weights');
    const { module } = this.#memory;
    this.#memory.accepted(module._pelt_set_crowd_weights(this.#handle, instance));
  }

  setVertices(instance, vertices) {
    this.#writeVertices(instance, vertices, 'vertices');
    const { module } = this.#memory;
    this.#memory.accepted(module._pelt_set_crowd_vertices(this.#handle, instance));
  }

  setOffsets(instance, offsets) {
    const { module } = this.#memory;
    if (offsets === null) {
      this.#member(instance);
      this.#memory.accepted(module._pelt_remove_crowd_offsets(this.#handle, instance));
      return;
    }
    this.#writeVertices(instance, offsets, 'offsets');
    this.#memory.accepted(module._pelt_set_crowd_offsets(this.#handle, instance));
  }

  setSelfFilter(instance, filter) {
    const { character, part } = this.#member(instance);
    const given = filter === null ? 0 : filterOf(this.#memory, filter, character, part);
    this.#memory.module._pelt_set_crowd_self_filter(this.#handle, instance, given);
  }

  filterParts(instances, filter) {
    if (!Array.isArray(instances)) throw invalid('instances: expected an array');
    this.#memory.handles.given(filter, SelfFilter, 'filter');
    instances.forEach((instance, i) => {
      const { character, part } = this.#member(instance);
      filterOf(this.#memory, filter, character, null);
      if (part === null) throw invalid(`instances[${i}]: expected a part, found a whole character`);
    });
    const { module, handles } = this.#memory;
    const number = module._pelt_add_crowd_part_filter(this.#handle, handles.of(filter));
    for (const instance of instances) {
      module._pelt_set_crowd_part_filter(this.#handle, instance, number);
    }
  }

  ignore(pairs) {
    const names = JSON.stringify(check.namePairs(pairs, 'ignore'));
    const { module } = this.#memory;
    this.#memory.withText(names, (json) =>
      this.#memory.accepted(module._pelt_ignore_in_crowd(this.#handle, json)),
    );
    this.#ignores = pairs.length > 0;
  }

  collide(options = undefined) {
    const most = mostContacts(this.#memory, options);
    this.#checkLimit(most);
    this.#memory.accepted(this.#memory.module._pelt_collide_crowd(this.#handle, most));
    return this.#readContacts();
  }

  beginStep() {
    this.#memory.module._pelt_begin_crowd_step(this.#handle);
  }

  setMotion(instance, from, to) {
    this.#writeMotion(instance, from, to, 16);
    const { module } = this.#memory;
    this.#memory.accepted(module._pelt_set_crowd_motion(this.#handle, instance));
  }

  setMotionDualQuaternions(instance, from, to) {
    this.#writeMotion(instance, from, to, 8);
    const { module } = this.#memory;
    this.#memory.accepted(module._pelt_set_crowd_dual_motion(this.#handle, instance));
  }

  collideMoving(options = undefined) {
    const read = readMovingOptions(this.#memory, options);
    this.#checkLimit(read.at(-1));
    this.#memory.accepted(this.#memory.module._pelt_collide_crowd_moving(this.#handle, ...read));
    const { count, contacts, ...rest } = this.#readContacts();
    return { count, contacts, ...readMovingColumns(this.#memory), ...rest };
  }

  withoutIgnored(contacts) {
    check.rows(contacts, 4, 'contacts').forEach((number, i) => this.#checkNumber(contacts, number, i));
    const { module } = this.#memory;
    this.#memory.withBytes(contacts, (address) =>
      this.#memory.accepted(
        module._pelt_without_ignored(this.#handle, address, contacts.length / 4),
      ),
    );
    return { contacts: this.#memory.data(Uint32Array, 4), ignored: this.#memory.field('ignored') };
  }

  delete() {
    this.#memory.handles.delete(this);
  }

  get #handle() {
    return this.#memory.handles.of(this);
  }

  #checkLimit(most) {
    if (!this.#ignores || most === check.kMaxCount) return;
    throw invalid(
      'a limit: cannot be combined with ignored pairs, because the first contacts may be ignored',
    );
  }

  #readContacts() {
    const contacts = this.#memory.data(Uint32Array, 4);
    return {
      count: contacts.length / 4,
      contacts,
      ignored: this.#memory.field('ignored'),
      leftOut: readLeftOut(this.#memory),
      stats: readStats(this.#memory),
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

  /** Writes palettes with `width` floats per joint, one after the other. */
  #writeMotion(instance, from, to, width) {
    const floats = width * this.#member(instance).character.jointCount;
    const address = this.#memory.module._pelt_crowd_input(this.#handle, 2 * floats);
    this.#memory.write(Float32Array, address, from, floats, 'from');
    this.#memory.write(Float32Array, address + 4 * floats, to, floats, 'to');
  }

  #writeVertices(instance, numbers, name) {
    const floats = 3 * this.#member(instance).character.vertexCount;
    const address = this.#memory.module._pelt_crowd_vertices(this.#handle, instance);
    this.#memory.write(Float32Array, address, numbers, floats, name);
  }

  #write(numbers, floats, name) {
    const address = this.#memory.module._pelt_crowd_input(this.#handle, floats);
    this.#memory.write(Float32Array, address, numbers, floats, name);
  }
}

export class ContactHash {
  #memory;

  constructor(memory) {
    this.#memory = memory;
    memory.handles.own(this, memory.module._pelt_make_hash(), '_pelt_delete_hash', 'hash');
  }

  add(frame, a, b, pairs) {
    const before = [check.count(frame, 'frame'), check.count(a, 'a'), check.count(b, 'b')];
    this.#memory.withBytes(check.rows(pairs, 2, 'pairs'), (address) =>
      this.#memory.module._pelt_hash_pairs(this.#handle, ...before, address, pairs.length / 2),
    );
  }

  addCrowd(frame, contacts) {
    check.count(frame, 'frame');
    this.#memory.withBytes(check.rows(contacts, 4, 'contacts'), (address) =>
      this.#memory.module._pelt_hash_crowd(this.#handle, frame, address, contacts.length / 4),
    );
  }

  get value() {
    this.#memory.module._pelt_hash_value(this.#handle);
    const hex = (number) => number.toString(16).padStart(8, '0');
    return hex(this.#memory.field('hashHigh')) + hex(this.#memory.field('hashLow'));
  }

  delete() {
    this.#memory.handles.delete(this);
  }

  get #handle() {
    return this.#memory.handles.of(this);
  }
}
