/** Characters from files: the same bits as natively, and the same words about bad ones. */

import assert from 'node:assert/strict';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import test from 'node:test';
import { MeshoptDecoder } from 'meshoptimizer';
import { skinnedRock } from './gltf.mjs';
import { kGenerated, kShared, pelt, posedByCommand, runCommand } from './support.mjs';

await MeshoptDecoder.ready;
const meshoptDecode = MeshoptDecoder.decodeGltfBuffer;

function read(file, options = {}) {
  const name = path.basename(file);
  return pelt.readCharacter(fs.readFileSync(file), { name, meshoptDecode, ...options });
}

function isCompressed(file) {
  return fs.readFileSync(file).includes('EXT_meshopt_compression');
}

const generated = fs.readdirSync(kGenerated).map((name) => path.join(kGenerated, name));

/** Posed at the third frame of its first clip by Pelt, natively and here. */
function comparePosed(file) {
  const character = read(file);
  const clip = character.clips.length > 0 ? character.clips[0].name : null;
  const scene = pelt.makeScene({ characters: [character], instances: [{ character: 0, clip }] });
  const pose = character.makePose();
  scene.setPose(pose, 0, 3);
  const [native] = posedByCommand(file, '--clip', clip ?? '-', '--frame', '3');
  assert.deepEqual(pose.posedVertices(), native);
  pose.delete();
  character.delete();
}

for (const file of generated) {
  test(`${path.basename(file)} is posed to the same bits as natively`, () => comparePosed(file));
}

test('some of the generated files are compressed', () => {
  assert.ok(generated.some(isCompressed));
});

test('a compressed file without a decoder is refused with the remedy', () => {
  const file = generated.find(isCompressed);
  assert.throws(() => read(file, { meshoptDecode: undefined }), {
    name: 'PeltError',
    code: 'unsupported',
    message: /EXT_meshopt_compression.*meshoptDecode.*npm package meshoptimizer/,
  });
});

const shared = ['knight.glb', 'robot_expressive.glb', 'morph_stress.glb', 'cesium_man.glb'];
for (const name of shared) {
  const file = path.join(kShared, 'models', name);
  const skip = !fs.existsSync(file) && `${file} is not there`;
  test(`${name} is posed to the same bits as natively`, { skip }, () => comparePosed(file));
}

test('broken files are refused in the words of the command', () => {
  const whole = fs.readFileSync(generated.find((file) => file.endsWith('.glb')));
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'pelt-'));
  let refused = 0;
  for (const length of [0, 3, 12, 40, 200, whole.length - 5]) {
    const file = path.join(folder, `cut_${length}.glb`);
    fs.writeFileSync(file, whole.subarray(0, length));
    const { err } = runCommand('info', file);
    const words = err.trim().slice(`pelt: error: ${file}: `.length);
    assert.throws(
      () => pelt.readCharacter(whole.subarray(0, length), { name: 'a.glb' }),
      { name: 'PeltError', message: `a.glb: ${words}` },
    );
    ++refused;
  }
  fs.rmSync(folder, { recursive: true });
  assert.equal(refused, 6);
});

test('a file that asks for more than an address holds is refused', () => {
  const accessor = { componentType: 5126, type: 'VEC3', count: 400_000_000 };
  const gltf = {
    asset: { version: '2.0' },
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0 }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0 } }] }],
    accessors: [accessor],
    extras: 'x'.repeat(20_000_000),
  };
  const file = new TextEncoder().encode(JSON.stringify(gltf));
  assert.throws(() => pelt.readCharacter(file, { name: 'huge' }), /out of proportion/);
});

test('off weights are refused with the remedy as it is called here', () => {
  const file = skinnedRock({ weight: 0.5 });
  assert.throws(() => pelt.readCharacter(file, { name: 'rock' }), {
    name: 'PeltError',
    code: 'invalid_argument',
    message: /^rock: weights of vertex 0 sum to 0\.5, expected 1 \(renormalise: true .*\)$/,
  });
  pelt.readCharacter(file, { name: 'rock', renormalise: true }).delete();
});

test('what a decoder does wrong is told, and not laid on the file alone', () => {
  const file = generated.find(isCompressed);
  const refused = (decode, message, cause) =>
    assert.throws(() => read(file, { meshoptDecode: decode }), (error) => {
      assert.equal(error.name, 'PeltError');
      assert.match(error.message, message);
      if (cause) assert.equal(error.cause, cause);
      return true;
    });
  const notReady = new TypeError('no exports yet');
  refused(() => { throw notReady; }, /accessor \d+ .*not ready; it says: no exports yet$/, notReady);
  refused(async () => {}, /it returned a promise/);
  refused(MeshoptDecoder, /^meshoptDecode: expected a function, found an object$/i);
  refused(() => pelt.generateCreature(), /the engine is busy: meshoptDecode must not call it/);
  refused(() => read(generated[0], { files: {} }), /the engine is busy/);
  read(file).delete();
});

test('a pose that cannot be is no extent', () => {
  const far = pelt.readCharacter(skinnedRock({ translation: [1e30, 0, 0] }), { name: 'far' });
  assert.throws(() => far.extent, { name: 'PeltError', message: /^far: palette\[0\]/ });
  far.delete();
});

test('a character tells what it is made of', () => {
  const character = pelt.generateCreature({ triangles: 2000, joints: 30, seed: 2, name: 'sand' });
  assert.equal(character.name, 'sand');
  assert.equal(character.triangleCount, 2000);
  assert.equal(character.triangles.length, 6000);
  assert.equal(character.restPositions.length, 3 * character.vertexCount);
  assert.ok(character.triangles.every((vertex) => vertex < character.vertexCount));
  assert.equal(character.jointNames.length, 30);
  assert.deepEqual(character.clips.map((clip) => clip.name), ['walk', 'idle']);
  assert.equal(character.parts.reduce((sum, part) => sum + part.triangleCount, 0), 2000);
  assert.ok(character.triangleParts.every((part) => part < character.parts.length));
  assert.ok(character.triangleJoints.every((joint) => joint < 30));
  assert.ok(new Set(character.triangleJoints).size > 10);
  const { low, high } = character.extent;
  assert.ok(high[1] - low[1] > 1.7 && high[1] - low[1] < 1.9);
  character.delete();
  assert.throws(() => character.makePose(), /character sand has been deleted/);
});

test('options out of range are refused', () => {
  assert.throws(() => pelt.generateCreature({ triangles: 10 }), /triangles/);
  assert.throws(() => pelt.generateCreature({ clips: ['fly'] }), /there is no clip "fly"/);
});
