/** The decoder of EXT_meshopt_compression, and its errors. */

/**
 * Calls `use()` with `decode` as the engine's decoder. It may throw nothing into the engine: what it
 * throws is returned as text for the message, and becomes the cause of the error that follows.
 */
export function withDecoder(memory, decode, use) {
  if (decode === undefined) return memory.withDecoder(undefined, use);
  let cause;
  const decodeOrTell = (...values) => {
    try {
      if (typeof decode(...values)?.then !== 'function') return '';
      throw new TypeError('it returned a promise: a decoder must be synchronous');
    } catch (error) {
      cause = error;
      return error instanceof Error ? error.message : String(error);
    }
  };
  try {
    return memory.withDecoder(decodeOrTell, use);
  } catch (error) {
    if (cause !== undefined) error.cause ??= cause;
    throw error;
  }
}
