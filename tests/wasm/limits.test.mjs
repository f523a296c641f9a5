/** Limits of memory: some requests are refused; others end the engine, with a message. */

import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import test from 'node:test';
import { rock, zeros } from './gltf.mjs';
import { kGenerated, loadPelt, pelt, refused } from './support.mjs';

const kPage = 65536;
const { grow } = WebAssembly.Memory.prototype;

/** Calls `use()` while the system limits the engine's memory to `bytes`, as on a phone. */
function withLittleMemory(bytes, use) {
  WebAssembly.Memory.prototype.grow = function (pages) {
    if (this.buffer.byteLength + pages * kPage > bytes) throw new RangeError('no more memory');
    return grow.call(this, pages);
  };
  try {
    return use();
  } finally {
    WebAssembly.Memory.prototype.grow = grow;
  }
}

function works(engine) {
  const character = engine.readCharacter(rock(), { name: 'rock' });
  assert.equal(character.extent.high[0], 1);
  character.delete();
}

test('a file that does not fit is refused, and the engine goes on', () => {
  const read = (bytes) => pelt.readCharacter(new Uint8Array(bytes), { name: 'large' });
  const words = (bytes) => new RegExp(`^${bytes} bytes do not fit into the engine's memory`);
  refused(() => read(2 ** 31), words(2 ** 31), 'out_of_memory');
  withLittleMemory(2 ** 26, () => {
    refused(() => read(2 ** 27), words(2 ** 27), 'out_of_memory');
  });
  assert.equal(pelt.hasEnded, false);
  works(pelt);
});

/** A file may need 256 MiB, and each vertex takes 58 bytes (asset/budget.hpp). */
test('a small file that asks for hardly less than is allowed is read, and one that asks for more is not', async () => {
  const engine = await loadPelt();
  const read = (vertices) =>
    engine.readCharacter(zeros({ bytes: 2 ** 20, vertices, triangles: 1 }), { name: 'zeros' });
  const character = read(4_600_000);
  assert.equal(character.restPositions.length, 3 * character.vertexCount);
  const words = /^zeros: .* out of proportion: the file would take more than 256 MiB of memory: /;
  for (const vertices of [4_700_000, 17_000_000, 80_000_000, 2 ** 32]) {
    refused(() => read(vertices), words, 'malformed_file');
  }
  read(4_600_000).delete();
  character.delete();
  works(engine);
});

test('a small file with more values than there is memory for is refused', async () => {
  const engine = await loadPelt();
  const nodes = (count) => {
    const text = `{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[${'{},'.repeat(count)}{}]}`;
    return () => engine.readCharacter(new TextEncoder().encode(text), { name: 'nodes' });
  };
  refused(nodes(990_000), /^nodes: the scene has no triangles: export/, 'unsupported');
  for (const count of [1_000_000, 8_000_000]) {
    refused(nodes(count), /^nodes: the JSON text has more than 2000000 values: /, 'malformed_file');
  }
  works(engine);
});

test('an engine that has run out of memory says so, and so do its objects', async () => {
  const engine = await loadPelt();
  const character = engine.generateCreature({ triangles: 1000, joints: 20 });
  const [a, b] = [character.makePose(), character.makePose()];
  const [crowd, hash] = [engine.makeCrowd(), engine.makeContactHash()];
  const scene = engine.makeScene({ characters: [character], instances: [{ character: 0 }] });
  const { triangles } = character;
  const large = () => engine.generateCreature({ triangles: 200_000 });
  withLittleMemory(2 ** 26, () => {
    refused(large, /^the engine ran out of memory and has ended: load a new one/, 'out_of_memory');
  });
  assert.equal(engine.hasEnded, true);
  const calls = [
    large,
    () => engine.readCharacter(rock(), { name: 'rock', files: {}, meshoptDecode: () => {} }),
    () => engine.readScene('s.json', {}),
    () => engine.collide(a, b),
    () => engine.distance(a, b),
    () => engine.makeCrowd(),
    () => engine.version,
    () => character.makePose(),
    () => character.palette('walk', 0),
    () => character.extent,
    () => a.posedVertices(),
    () => a.setPalette(new Float32Array(20 * 16)),
    () => crowd.add(character),
    () => hash.value,
    () => scene.setPose(a, 0, 0),
  ];
  for (const call of calls) {
    refused(call, /^the engine has ended because it ran out of memory: load a new one/, 'engine_ended');
  }
  assert.deepEqual(character.triangles, triangles);
  for (const made of [hash, crowd, a, b, scene, character]) made.delete();
  works(await loadPelt());
  works(pelt);
});

test('an engine that has failed otherwise says how', async () => {
  const engine = await loadPelt();
  const spite = new Error('in spite of all');
  const meshoptDecode = () => {
    throw { toString: () => { throw spite; } };
  };
  const read = () => engine.readCharacter(compressedFile(), { name: 'fox', meshoptDecode });
  assert.throws(read, {
    name: 'PeltError',
    code: 'engine_ended',
    message: /^the engine failed \(Error: in spite of all\) and has ended: load a new one/,
    cause: spite,
  });
  assert.equal(engine.hasEnded, true);
});

function compressedFile() {
  const files = fs.readdirSync(kGenerated).map((name) => fs.readFileSync(path.join(kGenerated, name)));
  return files.find((bytes) => bytes.includes('EXT_meshopt_compression'));
}
