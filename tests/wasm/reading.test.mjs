/** The options for reading a character, and their effects. */

import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import test from 'node:test';
import { pelt, runCommand, withFolder } from './support.mjs';

/** Two tetrahedra that ride on nodes, one the child of the other; their bytes are in a second file. */
const kPositions = Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1);
const kCorners = Uint16Array.of(0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3);
const kBytes = new Uint8Array([
  ...new Uint8Array(kPositions.buffer),
  ...new Uint8Array(kCorners.buffer),
]);
const kRocks = new TextEncoder().encode(
  JSON.stringify({
    asset: { version: '2.0' },
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [
      { name: 'boulder', mesh: 0, children: [1] },
      { name: 'pebble', mesh: 0, translation: [0.1, 0.1, 0.1], scale: [0.1, 0.1, 0.1] },
    ],
    meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1 }] }],
    accessors: [
      { bufferView: 0, componentType: 5126, type: 'VEC3', count: 4 },
      { bufferView: 1, componentType: 5123, type: 'SCALAR', count: 12 },
    ],
    bufferViews: [
      { buffer: 0, byteLength: 48 },
      { buffer: 0, byteOffset: 48, byteLength: 24 },
    ],
    buffers: [{ byteLength: 72, uri: 'bytes/rocks.bin' }],
  }),
);

const files = { 'bytes/rocks.bin': kBytes };

function readRocks(options = {}) {
  return pelt.readCharacter(kRocks, { name: 'rocks', files, ...options });
}

function partsOf(character) {
  const names = character.parts.map(({ name }) => name);
  character.delete();
  return names;
}

test('the files of a .gltf are found by their names', () => {
  const rocks = readRocks({ files: new Map(Object.entries(files)) });
  assert.equal(rocks.triangleCount, 8);
  assert.deepEqual(rocks.restPositions.subarray(0, 12), kPositions);
  assert.deepEqual(partsOf(rocks), ['boulder', 'pebble']);
  assert.throws(() => readRocks({ files: {} }), {
    code: 'unreadable_file',
    message: /bytes\/rocks\.bin/,
  });
});

test('meshes are left out by name and by kind, as by the command', () => {
  assert.deepEqual(partsOf(readRocks({ exclude: ['pebble'] })), ['boulder']);
  withFolder((folder) => {
    fs.mkdirSync(path.join(folder, 'bytes'));
    fs.writeFileSync(path.join(folder, 'bytes/rocks.bin'), kBytes);
    const file = path.join(folder, 'rocks');
    fs.writeFileSync(`${file}.gltf`, kRocks);
    const words = (...args) =>
      runCommand('info', `${file}.gltf`, ...args)
        .err.trim()
        .split('.gltf: ')[1];
    const refused = (options, ...args) =>
      assert.throws(() => readRocks(options), {
        name: 'PeltError',
        message: `rocks: ${words(...args)}`,
      });
    refused({ exclude: ['boulder'] }, '--exclude', 'boulder');
    refused({ exclude: ['bolder'] }, '--exclude', 'bolder');
    refused({ noUnskinned: true }, '--no-unskinned');
  });
});

test('a scene is read with the same choices', () => {
  const scene = new TextEncoder().encode(
    JSON.stringify({ models: { rocks: 'rocks.gltf' }, instances: [{ model: 'rocks' }] }),
  );
  const all = { 'scene.json': scene, 'rocks.gltf': kRocks, ...files };
  const read = pelt.readScene('scene.json', all, { exclude: ['pebble'] });
  assert.deepEqual(partsOf(read.characters[0]), ['boulder']);
  assert.throws(() => pelt.readScene('scene.json', all, { noUnskinned: true }), {
    name: 'PeltError',
  });
});

test('no answer depends on the poses that a character is prepared for', () => {
  const asked = [{}, { samples: 0 }, { samples: 1 }, { clips: [] }].map((options) => {
    const face = pelt.generateFace({ triangles: 3000, ...options });
    const [a, b] = [face.makePose(), face.makePose()];
    a.setPalette(face.palette('talk', 0.1));
    b.setPalette(face.palette('talk', 0.6, [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0.1, 0, 0, 1]));
    const found = pelt.collide(a, b);
    face.delete();
    return found;
  });
  for (const { pairs } of asked) assert.deepEqual(pairs, asked[0].pairs);
  assert.ok(asked[0].count > 100);
  const works = new Set(asked.map(({ stats }) => JSON.stringify(stats)));
  assert.ok(works.size > 1, 'the options changed nothing at all');
});

test('the engine is of the version of the command', () => {
  assert.equal(`pelt ${pelt.version}`, runCommand('--version').out.trim());
});
