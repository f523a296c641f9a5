/**
 * The one way into the engine. C++ that runs out of memory leaves by an exception and cleans nothing
 * up; what the engine holds may be half changed then. So whatever leaves a call that way ends the
 * engine, and nothing enters it any more.
 */

import { invalid, PeltError } from './errors.mjs';

const kOpen = 0;
const kInside = 1;
const kEnded = 2;

const kRemedy = 'load a new one with loadPelt()';

export class Gate {
  #module;
  #state = kOpen;
  #reason = '';

  constructor(module) {
    this.#module = module;
  }

  get hasEnded() {
    return this.#state === kEnded;
  }

  /** Functions of the engine by name. */
  calls() {
    const names = Object.keys(this.#module).filter((name) => name.startsWith('_'));
    return Object.fromEntries(names.map((name) => [name, this.#guard(name)]));
  }

  /** Throws if a call would throw. */
  requireOpen() {
    if (this.#state === kInside) throw invalid('the engine is busy: meshoptDecode must not call it');
    if (this.#state === kEnded) {
      throw new PeltError('engine_ended', `the engine has ended because it ${this.#reason}: ${kRemedy}`);
    }
  }

  /** Looks up a function at each call, because the engine replaces functions at their first call. */
  #guard(name) {
    const module = this.#module;
    return (...values) => {
      if (this.#state !== kOpen) this.requireOpen();
      this.#state = kInside;
      try {
        const result = module[name](...values);
        this.#state = kOpen;
        return result;
      } catch (error) {
        throw this.#end(error);
      }
    };
  }

  /** C++ exceptions are numbers here. Only the standard library throws, if memory runs out. */
  #end(error) {
    const isMemory = typeof error === 'number';
    this.#state = kEnded;
    this.#reason = isMemory ? 'ran out of memory' : `failed (${error})`;
    const advice = isMemory ? ', and delete() what is not needed any longer' : '';
    return new PeltError(
      isMemory ? 'out_of_memory' : 'engine_ended',
      `the engine ${this.#reason} and has ended: ${kRemedy}${advice}`,
      error,
    );
  }
}
