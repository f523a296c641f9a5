/** Files that are only in memory, for readers that open files by their names. */

import { invalid } from './memory.mjs';

const kFolder = '/files';

function parentOf(path) {
  return path.slice(0, path.lastIndexOf('/'));
}

/** What a path means in the folder; refuses those that lead out of it. */
function absolute(path) {
  const parts = [];
  for (const part of path.split('/')) {
    if (part === '..' && parts.pop() === undefined) throw invalid(`files: ${path} leads out`);
    if (part !== '' && part !== '.' && part !== '..') parts.push(part);
  }
  return [kFolder, ...parts].join('/');
}

function makeFolder(fs, path) {
  if (fs.analyzePath(path).exists) return;
  makeFolder(fs, parentOf(path));
  fs.mkdir(path);
}

function remove(fs, path) {
  if (!fs.isDir(fs.stat(path).mode)) return fs.unlink(path);
  for (const name of fs.readdir(path)) {
    if (name !== '.' && name !== '..') remove(fs, `${path}/${name}`);
  }
  fs.rmdir(path);
}

/** Calls `use(folder)` while the files are there, with their folder as working directory. */
export function withFiles({ FS: fs }, files, use) {
  makeFolder(fs, kFolder);
  const entries = files instanceof Map ? files : Object.entries(files);
  try {
    for (const [path, bytes] of entries) {
      makeFolder(fs, parentOf(absolute(path)));
      fs.writeFile(absolute(path), bytes);
    }
    fs.chdir(kFolder);
    return use(kFolder);
  } finally {
    fs.chdir('/');
    remove(fs, kFolder);
  }
}
