import { PeltError } from './errors.mjs';

/** A module whose only function returns a vector of zeros. */
const kUsesSimd = Uint8Array.of(
  ...[0x00, 0x61, 0x73, 0x6d, 0x01, 0x00, 0x00, 0x00],
  ...[0x01, 0x05, 0x01, 0x60, 0x00, 0x01, 0x7b],
  ...[0x03, 0x02, 0x01, 0x00],
  ...[0x0a, 0x08, 0x01, 0x06, 0x00, 0x41, 0x00, 0xfd, 0x0f, 0x0b],
);

/** Throws a readable error if SIMD is missing; otherwise compiling the engine would fail. */
export function requireSimd() {
  if (globalThis.WebAssembly?.validate(kUsesSimd)) return;
  throw new PeltError(
    'unsupported',
    'this browser or Node does not support WebAssembly with SIMD: use Chrome or Edge 91, ' +
      'Firefox 89, Safari 16.4, Node 18, or newer',
  );
}
