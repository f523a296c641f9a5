/** Lends the engine the files that a file names, and a decoder, while it reads that file. */

import * as check from './checks.mjs';
import { invalid, PeltError } from './errors.mjs';

const kFolder = '/files';

function parentOf(path) {
  return path.slice(0, Math.max(1, path.lastIndexOf('/')));
}

/** Resolves a path within the folder. Throws if the path leaves the folder. */
function absolute(path) {
  const parts = [];
  for (const part of path.split('/')) {
    if (part === '..' && parts.pop() === undefined) throw invalid(`files: ${path} leads out`);
    if (part !== '' && part !== '.' && part !== '..') parts.push(part);
  }
  return [kFolder, ...parts].join('/');
}

function isFolder(fs, path) {
  return fs.isDir(fs.stat(path).mode);
}

function makeFolder(fs, path) {
  if (fs.analyzePath(path).exists) {
    if (!isFolder(fs, path)) throw invalid(`files: ${path.slice(kFolder.length + 1)} is a folder, too`);
    return;
  }
  makeFolder(fs, parentOf(path));
  fs.mkdir(path);
}

function remove(fs, path) {
  if (!isFolder(fs, path)) return fs.unlink(path);
  for (const name of fs.readdir(path)) {
    if (name !== '.' && name !== '..') remove(fs, `${path}/${name}`);
  }
  fs.rmdir(path);
}

/** Returns [path, bytes] pairs of a Map or an object. */
function entriesOf(files) {
  const entries = files instanceof Map ? [...files] : Object.entries(check.object(files, 'files'));
  return entries.map(([path, bytes]) => [
    check.path(path, 'files'),
    check.bytes(bytes, `files: ${path}`),
  ]);
}

function write(fs, path, bytes) {
  const place = absolute(path);
  try {
    makeFolder(fs, parentOf(place));
    if (fs.analyzePath(place).exists && isFolder(fs, place)) {
      throw invalid(`files: ${path} is a folder, too`);
    }
    fs.writeFile(place, bytes);
  } catch (error) {
    if (error instanceof PeltError) throw error;
    throw new PeltError('out_of_memory', `files: ${path} does not fit into memory`, error);
  }
}

/** Calls `use(folder)` while the files exist, with their folder as working directory. */
export function withFiles(memory, files, use) {
  const entries = entriesOf(files);
  return memory.withFileSystem((fs) => {
    makeFolder(fs, kFolder);
    try {
      for (const [path, bytes] of entries) write(fs, path, bytes);
      fs.chdir(kFolder);
      return use(kFolder);
    } finally {
      fs.chdir('/');
      remove(fs, kFolder);
    }
  });
}

/**
 * Calls `use()` with `decode` as the engine's decoder of EXT_meshopt_compression. An exception of the
 * decoder must not enter the engine: its text is returned for the message, and the exception becomes the
 * cause of the error that follows.
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
