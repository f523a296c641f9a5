/** Handles of the engine's objects: their addresses, which are private to this file. */

import { kindOf } from './checks.mjs';
import { invalid } from './errors.mjs';

export class Handles {
  #memory;
  #held = new WeakMap();
  #graves = new FinalizationRegistry((grave) => this.#remove(grave));

  constructor(memory) {
    this.#memory = memory;
  }

  /** Makes `owner` the owner of an object, which is freed when `owner` is deleted or collected. */
  own(owner, address, remove, name) {
    this.#held.set(owner, { address, remove, name });
    this.#graves.register(owner, { address, remove }, owner);
  }

  /** Returns the address. Throws for a deleted object, which would corrupt the engine's memory. */
  of(owner) {
    const { address, name } = this.#held.get(owner);
    if (address === 0) throw invalid(`the ${name} has been deleted`);
    return address;
  }

  /** Checks an argument, which must be a `type` of this engine that is not deleted. Returns it. */
  given(object, type, argument) {
    if (!(object instanceof type)) {
      throw invalid(`${argument}: expected a ${type.name}, found ${kindOf(object)}`);
    }
    if (!this.#held.has(object)) throw invalid(`${argument}: it belongs to another engine`);
    this.of(object);
    return object;
  }

  delete(owner) {
    const held = this.#held.get(owner);
    if (held.address === 0) return;
    this.#graves.unregister(owner);
    this.#remove(held);
    held.address = 0;
  }

  /** Frees an object, unless it has ended with the engine. */
  #remove({ address, remove }) {
    if (!this.#memory.hasEnded) this.#memory.call(remove, address);
  }
}
