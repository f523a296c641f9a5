/** What is deleted, or refused, leaves nothing behind. */

import assert from 'node:assert/strict';
import test from 'node:test';
import { pelt } from './support.mjs';

function encode(json) {
  return new TextEncoder().encode(JSON.stringify(json));
}

/** A tetrahedron that rides on a node. */
function rock() {
  const positions = Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1);
  const corners = Uint16Array.of(0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3);
  const bytes = Buffer.concat([Buffer.from(positions.buffer), Buffer.from(corners.buffer)]);
  const uri = `data:application/octet-stream;base64,${bytes.toString('base64')}`;
  return encode({
    asset: { version: '2.0' },
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ name: 'rock', mesh: 0 }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1 }] }],
    accessors: [
      { bufferView: 0, componentType: 5126, type: 'VEC3', count: 4 },
      { bufferView: 1, componentType: 5123, type: 'SCALAR', count: 12 },
    ],
    bufferViews: [
      { buffer: 0, byteLength: 48 },
      { buffer: 0, byteOffset: 48, byteLength: 24 },
    ],
    buffers: [{ byteLength: 72, uri }],
  });
}

const kFiles = {
  'scenes/rocks.json': encode({
    models: { rock: '../models/rock.gltf' },
    instances: [{ model: 'rock' }, { model: 'rock', translation: [0.2, 0.2, 0.2] }],
  }),
  'models/rock.gltf': rock(),
};

function useEverything() {
  const scene = pelt.readScene('scenes/rocks.json', kFiles);
  const poses = scene.instances.map(({ character }) => scene.characters[character].makePose());
  poses.forEach((pose, i) => scene.setPose(pose, i, 0));
  const { pairs, count } = pelt.collide(...poses);
  assert.ok(count > 0);
  pelt.collideEagerly(...poses);
  pelt.describeContacts(...poses, pairs);
  pelt.distance(...poses);
  for (const pose of poses) {
    pose.normals();
    pose.nodeBoxes(1);
    pose.tightBounds();
  }
  const crowd = pelt.makeCrowd();
  const hash = pelt.makeContactHash();
  for (const { character } of scene.instances) crowd.add(scene.characters[character]);
  hash.addCrowd(0, crowd.collide().contacts);
  for (const made of [crowd, hash, ...poses, scene]) made.delete();
  assert.throws(() => pelt.readCharacter(rock().subarray(0, 300), { name: 'half' }));
  assert.throws(() => pelt.readScene('scenes/rocks.json', { ...kFiles, 'models/rock.gltf': [] }));
}

test('the engine uses no more memory after many scenes than after one', () => {
  for (let i = 0; i < 3; ++i) useEverything();
  const before = pelt.bytesInUse;
  for (let i = 0; i < 50; ++i) useEverything();
  assert.ok(pelt.bytesInUse - before < 1024, `${pelt.bytesInUse - before} bytes more`);
});

test('what is deleted twice, or used after that, is refused and not freed again', () => {
  const character = pelt.readCharacter(rock(), { name: 'rock' });
  const pose = character.makePose();
  character.delete();
  character.delete();
  pose.posedVertices();
  pose.delete();
  assert.throws(() => pose.posedVertices(), /pose of rock has been deleted/);
  const hash = pelt.makeContactHash();
  hash.delete();
  assert.throws(() => hash.value, /hash has been deleted/);
});
