/** Internals for Pelt's own tests; the package does not export them. */

const memories = new WeakMap();

export function expose(pelt, memory) {
  memories.set(pelt, memory);
}

/** Returns the heap memory of all objects that are not deleted. */
export function bytesInUse(pelt) {
  return memories.get(pelt).module._pelt_bytes_in_use();
}
