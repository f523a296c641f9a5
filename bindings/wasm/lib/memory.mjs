/**
 * The one way into the engine: calls, their arguments and their answers (export.hpp and answer.hpp).
 * The engine may move its memory when the memory grows, so views of it are created for each access
 * and never stored.
 */

import { invalid, PeltError } from './errors.mjs';
import { Handles } from './handles.mjs';

/** Limit of Emscripten: half of the 32-bit address space. */
const kMaxBytes = 2 ** 31;

/** Arguments are written first, and copies of small arrays and texts behind them. */
const kMaxArguments = 32;

const kHeap = new Map([
  [Uint8Array, 'HEAPU8'],
  [Uint16Array, 'HEAPU16'],
  [Uint32Array, 'HEAPU32'],
  [Float32Array, 'HEAPF32'],
  [Float64Array, 'HEAPF64'],
]);

const kOpen = 0;
const kInside = 1;
const kEnded = 2;

const kRemedy = 'load a new one with loadPelt()';

export class Memory {
  #engine;
  #layout;
  #state = kOpen;
  #reason = '';
  #unused = 0; // where the next copy may be written

  constructor(engine) {
    this.#engine = engine;
    this.handles = new Handles(this);
    this.#layout = JSON.parse(engine.UTF8ToString(this.#enter('_pelt_layout')));
  }

  /**
   * Calls a function of the engine, and returns the number that it returns, or throws its error. An
   * object of the engine is passed as its handle, a text or a typed array as a copy.
   */
  call(name, ...values) {
    this.requireOpen();
    this.#unused = this.#layout.input + 8 * kMaxArguments;
    const allocated = [];
    try {
      const numbers = [];
      for (const value of values) this.#addNumbers(numbers, value, allocated);
      this.#engine.HEAPF64.set(numbers, this.#layout.input / 8);
      const result = this.#enter(`_pelt_${name}`);
      if (!Number.isNaN(result)) return result;
    } finally {
      if (!this.hasEnded) allocated.forEach((address) => this.#enter('_free', address));
    }
    const { code, message } = JSON.parse(this.#engine.UTF8ToString(this.#enter('_pelt_error')));
    throw new PeltError(code, message);
  }

  /** Calls a function that returns a text. */
  text(name, ...values) {
    return this.#engine.UTF8ToString(this.call(name, ...values));
  }

  json(name, ...values) {
    return JSON.parse(this.text(name, ...values));
  }

  /** Returns a field of the answer of the last call: a number, or an array of three. */
  field(name) {
    const [offset, doubles] = this.#layout.fields[name];
    const numbers = this.view(Float64Array, this.#layout.answer + offset, doubles);
    return doubles === 1 ? numbers[0] : Array.from(numbers);
  }

  /** Returns the fields of these names as an object. */
  fields(...names) {
    return Object.fromEntries(names.map((name) => [name, this.field(name)]));
  }

  /** Returns the work of the last query. */
  stats() {
    return {
      ...this.fields('nodePairs', 'refits', 'posedVertices', 'trianglePairs'),
      ...this.fields('displacements', 'clampedOffsets'),
      cutShort: this.field('cutShort') !== 0,
    };
  }

  /** Returns an array of the answer of the last call; in `out`, if given. */
  array(type, index = 0, out = undefined) {
    const place = this.#layout.answer + this.#layout.arrays + 8 * index;
    const [address, bytes] = this.view(Uint32Array, place, 2);
    const length = bytes / type.BYTES_PER_ELEMENT;
    const copy = out === undefined ? new type(length) : out;
    if (!(copy instanceof type) || copy.length !== length) {
      throw invalid(`out: expected a ${type.name} of ${length} elements`);
    }
    if (length > 0) copy.set(this.view(type, address, length));
    return copy;
  }

  /** Returns arrays as an object. `columns` has their names and types. */
  arrays(columns, first = 0) {
    return Object.fromEntries(
      columns.map(([name, type], column) => [name, this.array(type, first + column)]),
    );
  }

  /** Returns a view of `length` elements, valid until the next call of the engine. */
  view(type, address, length) {
    const heap = this.#engine[kHeap.get(type)];
    const first = address / type.BYTES_PER_ELEMENT;
    return heap.subarray(first, first + length);
  }

  /** Calls `use(files)` with the file system that the engine reads. */
  withFileSystem(use) {
    this.requireOpen();
    return use(this.#engine.FS);
  }

  /** Calls `use()`, in which the engine may call `decode` (meshopt_decoder.cpp). */
  withDecoder(decode, use) {
    this.requireOpen();
    this.#engine.meshoptDecode = decode;
    try {
      return use();
    } finally {
      this.#engine.meshoptDecode = undefined;
    }
  }

  /** Returns the end of a message about an unknown name. */
  suggestion(name, known) {
    return this.text('suggestion', JSON.stringify([name, ...known]));
  }

  get hasEnded() {
    return this.#state === kEnded;
  }

  /** Throws if a call would throw. */
  requireOpen() {
    if (this.#state === kInside) throw invalid('the engine is busy: meshoptDecode must not call it');
    if (this.#state === kEnded) {
      throw new PeltError('engine_ended', `the engine has ended because it ${this.#reason}: ${kRemedy}`);
    }
  }

  /** Adds the numbers that the engine gets for a value. */
  #addNumbers(numbers, value, allocated) {
    if (typeof value === 'number') numbers.push(value);
    else if (typeof value === 'boolean') numbers.push(value ? 1 : 0);
    else if (value === null) numbers.push(0);
    else if (typeof value === 'string') this.#addCopy(numbers, new TextEncoder().encode(value), allocated);
    else if (ArrayBuffer.isView(value)) this.#addCopy(numbers, value, allocated);
    else numbers.push(this.handles.of(value));
  }

  /** Adds the address of a copy, and its length in bytes. */
  #addCopy(numbers, { buffer, byteOffset, byteLength }, allocated) {
    let address = this.#unused;
    if (address + byteLength > this.#layout.input + this.#layout.inputBytes) {
      address = this.#allocate(byteLength);
      allocated.push(address);
    } else {
      this.#unused += 8 * Math.ceil(byteLength / 8);
    }
    this.#engine.HEAPU8.set(new Uint8Array(buffer, byteOffset, byteLength), address);
    numbers.push(address, byteLength);
  }

  #allocate(bytes) {
    const address = bytes < kMaxBytes ? this.#enter('_malloc', bytes) : 0;
    if (address !== 0) return address;
    throw new PeltError(
      'out_of_memory',
      `${bytes} bytes do not fit into the engine's memory, which has 2 GB at most: delete() what ` +
        'is not needed any longer, or load another engine',
    );
  }

  /**
   * C++ that runs out of memory throws, and cleans nothing up: the data of the engine may be half
   * changed. Any exception that leaves a call therefore ends the engine, and nothing enters it any
   * more.
   */
  #enter(name, ...numbers) {
    this.#state = kInside;
    try {
      const result = this.#engine[name](...numbers);
      this.#state = kOpen;
      return result;
    } catch (error) {
      throw this.#end(error);
    }
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
