/** Access to the memory of an engine, for pelt.mjs and Pelt's own tests. Not exported by the package. */

const memories = new WeakMap();

export function expose(pelt, memory) {
  memories.set(pelt, memory);
}

export function memoryOf(pelt) {
  return memories.get(pelt);
}

/** Returns the heap memory of all objects that are not deleted. */
export function bytesInUse(pelt) {
  return memoryOf(pelt).call('bytes_in_use');
}
