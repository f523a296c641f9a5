/**
 * Access to the engine's memory from JavaScript: numbers, arrays and texts. The engine may move its
 * memory when the memory grows, so views of it are created for each access and never stored.
 */

import * as check from './checks.mjs';
import { invalid, PeltError } from './errors.mjs';
import { Gate } from './gate.mjs';
import { Handles } from './handles.mjs';

/** Limit of Emscripten: half of the 32-bit address space. */
const kMaxBytes = 2 ** 31;

const kHeap = new Map([
  [Uint8Array, 'HEAPU8'],
  [Uint16Array, 'HEAPU16'],
  [Uint32Array, 'HEAPU32'],
  [Float32Array, 'HEAPF32'],
  [Float64Array, 'HEAPF64'],
]);

export class Memory {
  #engine;
  #answer;
  #layout;

  constructor(engine) {
    this.#engine = engine;
    this.gate = new Gate(engine);
    /** Functions of the engine, called through the gate. */
    this.module = this.gate.calls();
    this.handles = new Handles(this.gate, this.module);
    this.#answer = this.module._pelt_answer();
    this.#layout = this.json(this.module._pelt_answer_layout());
  }

  /** Returns a view of `length` elements, valid until the next call of the engine. */
  view(type, address, length) {
    const heap = this.#engine[kHeap.get(type)];
    const first = address / type.BYTES_PER_ELEMENT;
    return heap.subarray(first, first + length);
  }

  /** Returns a field of the answer of the last call (answer.hpp): a number, or an array of three. */
  field(name) {
    const [offset, doubles] = this.#layout.fields[name];
    const address = this.#answer + offset;
    if (doubles === 1) return this.#engine.HEAPF64[address / 8];
    return Array.from(this.view(Float64Array, address, doubles));
  }

  /** Returns the answer of the last call with `width` numbers per element; in `out`, if given. */
  data(type, width, out) {
    const [address, count] = this.view(Uint32Array, this.#answer + this.#layout.data, 2);
    return this.copy(type, address, count * width, out);
  }

  copy(type, address, length, out = new type(length)) {
    if (!(out instanceof type) || out.length !== length) {
      throw invalid(`out: expected a ${type.name} of ${length} elements`);
    }
    if (length > 0) out.set(this.view(type, address, length));
    return out;
  }

  /** Writes numbers to the memory where the engine expects them. */
  write(type, address, numbers, length, name) {
    check.numbers(numbers, length, name);
    if (length > 0) this.view(type, address, length).set(numbers);
  }

  text(address) {
    return this.#engine.UTF8ToString(address);
  }

  json(address) {
    return JSON.parse(this.text(address));
  }

  /** Calls `use(address)` while the bytes of a typed array are in the engine's memory. */
  withBytes({ buffer, byteOffset, byteLength }, use) {
    const address = this.#allocate(byteLength);
    const bytes = new Uint8Array(buffer, byteOffset, byteLength);
    this.view(Uint8Array, address, byteLength).set(bytes);
    try {
      return use(address);
    } finally {
      if (!this.gate.hasEnded) this.module._free(address);
    }
  }

  withText(text, use) {
    return this.withBytes(new TextEncoder().encode(`${text}\0`), use);
  }

  /** Calls `use(files)` with the file system that the engine reads. */
  withFileSystem(use) {
    this.gate.requireOpen();
    return use(this.#engine.FS);
  }

  /** Calls `use()`, in which the engine may call `decode` (meshopt_decoder.cpp). */
  withDecoder(decode, use) {
    this.gate.requireOpen();
    this.#engine.meshoptDecode = decode;
    try {
      return use();
    } finally {
      this.#engine.meshoptDecode = undefined;
    }
  }

  /** Returns the result of the engine, or throws its error. */
  accepted(result) {
    if (result) return result;
    const { code, message } = this.json(this.module._pelt_error());
    throw new PeltError(code, message);
  }

  /** Returns the end of a message about an unknown name. */
  suggestion(name, known) {
    const words = JSON.stringify([name, ...known]);
    return this.withText(words, (address) => this.text(this.module._pelt_suggestion(address)));
  }

  #allocate(bytes) {
    const address = bytes < kMaxBytes ? this.module._malloc(Math.max(bytes, 1)) : 0;
    if (address !== 0) return address;
    throw new PeltError(
      'out_of_memory',
      `${bytes} bytes do not fit into the engine's memory, which has 2 GB at most: delete() what ` +
        'is not needed any longer, or load another engine',
    );
  }
}
