import { alive, invalid } from './memory.mjs';
import { mostContacts, readStats } from './queries.mjs';

const kRemoveCrowd = '_pelt_delete_crowd';
const kRemoveHash = '_pelt_delete_hash';

export class Crowd {
  #memory;
  #handle;
  #characters = [];
  #ignores = false;

  constructor(memory) {
    this.#memory = memory;
    this.#handle = memory.own(this, memory.module._pelt_make_crowd(), kRemoveCrowd);
  }

  add(character, part = null) {
    const { module } = this.#memory;
    const named = character.partNumber(part);
    this.#memory.accepted(module._pelt_add_to_crowd(this.#alive(), character.handle, named));
    const number = this.#memory.number(0);
    this.#characters[number] = character;
    return number;
  }

  setPalette(instance, palette) {
    const floats = 16 * this.#character(instance).jointCount;
    this.#write(palette, floats, 'palette');
    const { module } = this.#memory;
    this.#memory.accepted(module._pelt_set_crowd_palette(this.#handle, instance));
  }

  setMorphWeights(instance, weights) {
    this.#write(weights, this.#character(instance).morphTargetNames.length, 'weights');
    const { module } = this.#memory;
    this.#memory.accepted(module._pelt_set_crowd_weights(this.#handle, instance));
  }

  ignore(pairs) {
    const names = JSON.stringify(checkedPairs(pairs));
    const { module } = this.#memory;
    this.#memory.withText(names, (json) => module._pelt_ignore_in_crowd(this.#alive(), json));
    this.#ignores = pairs.length > 0;
  }

  collide(options = {}) {
    const most = mostContacts(options);
    if (this.#ignores && most !== mostContacts()) {
      throw invalid('a limit: the contacts found first may be those to ignore');
    }
    this.#memory.accepted(this.#memory.module._pelt_collide_crowd(this.#alive(), most));
    const contacts = this.#memory.data(Uint32Array, 4);
    return {
      count: contacts.length / 4,
      contacts,
      ignored: this.#memory.number(6),
      stats: readStats(this.#memory),
    };
  }

  delete() {
    this.#handle = this.#memory.disown(this, this.#handle, kRemoveCrowd);
  }

  #alive() {
    return alive(this.#handle, 'crowd');
  }

  #character(instance) {
    const character = this.#characters[instance];
    if (character === undefined) throw invalid(`instance: the crowd has no instance ${instance}`);
    return character;
  }

  #write(numbers, floats, name) {
    const address = this.#memory.module._pelt_crowd_input(this.#alive(), floats);
    this.#memory.write(Float32Array, address, numbers, floats, name);
  }
}

function checkedPairs(pairs) {
  const isPair = (pair) =>
    Array.isArray(pair) && pair.length === 2 && pair.every((name) => typeof name === 'string');
  if (Array.isArray(pairs) && pairs.every(isPair)) return pairs;
  throw invalid('ignore: expected an array of pairs of names');
}

export class ContactHash {
  #memory;
  #handle;

  constructor(memory) {
    this.#memory = memory;
    this.#handle = memory.own(this, memory.module._pelt_make_hash(), kRemoveHash);
  }

  add(frame, a, b, pairs) {
    for (let i = 0; i < pairs.length; i += 2) {
      for (const value of [frame, a, b, pairs[i], pairs[i + 1]]) this.#add(value);
    }
  }

  addCrowd(frame, contacts) {
    for (let i = 0; i < contacts.length; i += 4) {
      this.#add(frame);
      for (const value of contacts.subarray(i, i + 4)) this.#add(value);
    }
  }

  get value() {
    this.#memory.module._pelt_hash_value(alive(this.#handle, 'hash'));
    const hex = (number) => number.toString(16).padStart(8, '0');
    return hex(this.#memory.number(0)) + hex(this.#memory.number(1));
  }

  delete() {
    this.#handle = this.#memory.disown(this, this.#handle, kRemoveHash);
  }

  #add(value) {
    this.#memory.module._pelt_add_to_hash(alive(this.#handle, 'hash'), value);
  }
}
