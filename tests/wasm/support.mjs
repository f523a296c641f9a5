/** Shared by the tests of the npm package: the package itself, the command, and files. */

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

export const kPackage = process.env.PELT_WASM_PACKAGE;
export const kScenes = process.env.PELT_SCENES_DIR;
export const kShared = process.env.PELT_SHARED_DIR;
export const kGenerated = process.env.PELT_GENERATED_DIR;
export const kFaces = fileURLToPath(new URL('faces.json', import.meta.url));

export const { ContactKind, FeatureKind, loadPelt, NodeState, PeltError } = await import(
  path.join(kPackage, 'pelt.mjs')
);
const internals = await import(path.join(kPackage, 'lib/internals.mjs'));
export const pelt = await loadPelt();

/** Heap in use by what has not been deleted. */
export const bytesInUse = () => internals.bytesInUse(pelt);

/** Asserts that Pelt refuses a call in these words. */
export function refused(use, message, code = 'invalid_argument') {
  assert.throws(use, { name: 'PeltError', code, message });
}

/** Runs the command `pelt`. */
export function runCommand(...args) {
  const ended = spawnSync(process.env.PELT_COMMAND, args, { encoding: 'utf8', maxBuffer: 1 << 28 });
  if (ended.error) throw ended.error;
  return { status: ended.status, out: ended.stdout, err: ended.stderr };
}

/** The lines that a verb of the command prints with --jsonl. */
export function jsonLines(...args) {
  const { out, err } = runCommand(...args, '--jsonl', '-');
  if (out === '') throw new Error(err);
  return out
    .trim()
    .split('\n')
    .map((line) => JSON.parse(line));
}

const inCamelCase = (name) => name.replace(/_(.)/g, (_, letter) => letter.toUpperCase());

/** Contacts, hash and work of all frames, from `pelt check`. */
export function nativeTotals(scene, frames, ...options) {
  const lines = jsonLines('check', scene, '--frames', frames, ...options);
  const { totals, hash, counters } = lines.at(-1);
  const work = Object.entries(counters).map(([name, count]) => [inCamelCase(name), count]);
  return { contacts: totals.contacts, hash, work: Object.fromEntries(work) };
}

/** A folder for the length of `use(folder)`. */
export function withFolder(use) {
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'pelt-'));
  try {
    return use(folder);
  } finally {
    fs.rmSync(folder, { recursive: true });
  }
}

/** A scene file on disk as the package reads it. */
export function readSceneFile(file, options = {}) {
  const root = path.resolve(path.dirname(file), '..');
  return pelt.readScene(path.relative(root, file), filesOfScene(file, root), options);
}

/** The files that a scene file names, with itself, by their paths below `root`. */
function filesOfScene(scene, root) {
  const files = new Map();
  const add = (file) => files.set(path.relative(root, file), fs.readFileSync(file));
  add(scene);
  for (const model of Object.values(JSON.parse(fs.readFileSync(scene, 'utf8')).models)) {
    if (typeof model === 'string') add(path.resolve(path.dirname(scene), model));
  }
  return files;
}

/** [instance a, instance b, ...pair] of instances 0 and 1, one after the other, as crowds list them. */
export const contactsOf = (pairs) => [...pairs].flatMap((t, i) => (i % 2 ? [t] : [0, 1, t]));

/** Returns the bodies that a crowd has: the instances of a scene, or each of their parts. */
export function bodiesOf(scene, byPart) {
  return scene.instances.flatMap(({ character }, instance) => {
    const { parts } = scene.characters[character];
    return byPart ? parts.map((_, part) => ({ instance, part })) : [{ instance, part: null }];
  });
}

/** The frames of "A:B" or "A:B:S". */
export function framesOf(range) {
  const [begin, end, stride = 1] = range.split(':').map(Number);
  const frames = [];
  for (let frame = begin; frame < end; frame += stride) frames.push(frame);
  return frames;
}

/** The positions of each node of a .glb that `pelt pose` has written. */
export function posedByCommand(...args) {
  return withFolder((folder) => {
    const file = path.join(folder, 'posed.glb');
    const { status, err } = runCommand('pose', ...args, '-o', file);
    if (status !== 0) throw new Error(err);
    return readPositions(fs.readFileSync(file));
  });
}

function readPositions(glb) {
  const jsonLength = glb.readUInt32LE(12);
  const gltf = JSON.parse(glb.toString('utf8', 20, 20 + jsonLength));
  const binary = 20 + jsonLength + 8;
  return gltf.meshes.map(({ primitives: [{ attributes }] }) => {
    const accessor = gltf.accessors[attributes.POSITION];
    const view = gltf.bufferViews[accessor.bufferView];
    const begin = binary + (view.byteOffset ?? 0) + (accessor.byteOffset ?? 0);
    const bytes = Uint8Array.from(glb.subarray(begin, begin + 12 * accessor.count));
    return new Float32Array(bytes.buffer);
  });
}
