/** What Pelt's own tests ask of an engine; the package does not export it. */

const memories = new WeakMap();

export function expose(pelt, memory) {
  memories.set(pelt, memory);
}

/** Heap in use by what has not been deleted. */
export function bytesInUse(pelt) {
  return memories.get(pelt).module._pelt_bytes_in_use();
}
