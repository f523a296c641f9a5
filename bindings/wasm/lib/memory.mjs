/**
 * The engine's memory as JavaScript sees it: numbers, arrays and texts in and out. The engine may
 * move its memory whenever it takes more, so views of it are taken anew each time and never kept.
 */

/** The answer's numbers, then the address and the number of elements of its data. */
const kNumbers = 16;

const kHeap = new Map([
  [Uint8Array, 'HEAPU8'],
  [Uint16Array, 'HEAPU16'],
  [Uint32Array, 'HEAPU32'],
  [Float32Array, 'HEAPF32'],
  [Float64Array, 'HEAPF64'],
]);

export class PeltError extends Error {
  constructor(code, message) {
    super(message);
    this.name = 'PeltError';
    this.code = code;
  }
}

export function invalid(message) {
  return new PeltError('invalid_argument', message);
}

export class Memory {
  constructor(module) {
    this.module = module;
    this.answer = module._pelt_answer();
    this.graves = new FinalizationRegistry(({ remove, handle }) => module[remove](handle));
  }

  /** A view of `length` elements; not to be kept. */
  view(type, address, length) {
    const heap = this.module[kHeap.get(type)];
    const first = address / type.BYTES_PER_ELEMENT;
    return heap.subarray(first, first + length);
  }

  number(i) {
    return this.module.HEAPF64[this.answer / 8 + i];
  }

  numbers(begin, end) {
    return Array.from(this.view(Float64Array, this.answer + 8 * begin, end - begin));
  }

  /** What the last call has answered, `width` numbers an element; into `out`, if there is one. */
  data(type, width, out) {
    const [address, count] = this.view(Uint32Array, this.answer + 8 * kNumbers, 2);
    return this.copy(type, address, count * width, out);
  }

  copy(type, address, length, out = new type(length)) {
    if (!(out instanceof type) || out.length !== length) {
      throw invalid(`out: expected a ${type.name} of ${length} elements`);
    }
    if (length > 0) out.set(this.view(type, address, length));
    return out;
  }

  /** Writes numbers where the engine expects so many. */
  write(type, address, numbers, length, name) {
    if (numbers.length !== length) {
      throw invalid(`${name}: expected ${length} numbers, found ${numbers.length}`);
    }
    if (length > 0) this.view(type, address, length).set(numbers);
  }

  text(address) {
    return this.module.UTF8ToString(address);
  }

  json(address) {
    return JSON.parse(this.text(address));
  }

  /** Calls `use(address)` with bytes that are there meanwhile. */
  withBytes(bytes, use) {
    const address = this.module._malloc(Math.max(bytes.length, 1));
    this.module.HEAPU8.set(bytes, address);
    try {
      return use(address);
    } finally {
      this.module._free(address);
    }
  }

  withText(text, use) {
    return this.withBytes(new TextEncoder().encode(`${text}\0`), use);
  }

  /** What the engine returned, or the reason why it has refused. */
  accepted(result) {
    if (result) return result;
    const { code, message } = this.json(this.module._pelt_error());
    throw new PeltError(code, message);
  }

  /** Sees to it that `owner`'s handle is given back when it is forgotten. */
  own(owner, handle, remove) {
    this.graves.register(owner, { remove, handle }, owner);
    return handle;
  }

  /** Gives it back now. */
  disown(owner, handle, remove) {
    if (handle === 0) return 0;
    this.graves.unregister(owner);
    this.module[remove](handle);
    return 0;
  }
}

/** A deleted object says so instead of breaking the engine's memory. */
export function alive(handle, name) {
  if (handle === 0) throw invalid(`the ${name} has been deleted`);
  return handle;
}
