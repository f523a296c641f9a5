/** What JavaScript holds of the engine's objects: their addresses, which nobody else is told. */

import { kindOf } from './checks.mjs';
import { invalid } from './errors.mjs';

export class Handles {
  #gate;
  #calls;
  #held = new WeakMap();
  #graves = new FinalizationRegistry((grave) => this.#remove(grave));

  constructor(gate, calls) {
    this.#gate = gate;
    this.#calls = calls;
  }

  /** From now on `owner` has that object, which is given back when it is deleted or forgotten. */
  own(owner, address, remove, name) {
    this.#held.set(owner, { address, remove, name });
    this.#graves.register(owner, { address, remove }, owner);
  }

  /** A deleted object says so instead of breaking the engine's memory. */
  of(owner) {
    const { address, name } = this.#held.get(owner);
    if (address === 0) throw invalid(`the ${name} has been deleted`);
    return address;
  }

  /** The same of what a caller hands over: it has to be a `type`, and of this engine. */
  given(object, type, argument) {
    if (!(object instanceof type)) {
      throw invalid(`${argument}: expected a ${type.name}, found ${kindOf(object)}`);
    }
    if (!this.#held.has(object)) throw invalid(`${argument}: it is of another engine`);
    return this.of(object);
  }

  delete(owner) {
    const held = this.#held.get(owner);
    if (held.address === 0) return;
    this.#graves.unregister(owner);
    this.#remove(held);
    held.address = 0;
  }

  /** All that an ended engine had has gone with it. */
  #remove({ address, remove }) {
    if (!this.#gate.hasEnded) this.#calls[remove](address);
  }
}
