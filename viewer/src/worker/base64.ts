/** Files as a report has them. */

import type { NamedFile } from './protocol';

export function decodeFiles(files: Readonly<Record<string, string>>): NamedFile[] {
  return Object.entries(files).map(([path, base64]) => ({ path, bytes: decode(base64) }));
}

function decode(base64: string): Uint8Array<ArrayBuffer> {
  const letters = atob(base64);
  const bytes = new Uint8Array(letters.length);
  for (let i = 0; i < bytes.length; ++i) bytes[i] = letters.charCodeAt(i);
  return bytes;
}
