/** Deleted, forgotten and refused objects leave no memory allocated. */

import assert from 'node:assert/strict';
import test from 'node:test';
import v8 from 'node:v8';
import vm from 'node:vm';
import { encode, rock, skinnedRock } from './gltf.mjs';
import { bytesInUse, pelt } from './support.mjs';

const kFiles = {
  'scenes/rocks.json': encode({
    models: { rock: '../models/rock.gltf' },
    instances: [{ model: 'rock' }, { model: 'rock', translation: [0.2, 0.2, 0.2] }],
  }),
  'scenes/two.json': encode({
    models: { rock: '../models/rock.gltf', zero: '../models/half.gltf' },
    instances: [{ model: 'rock' }, { model: 'zero' }],
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
  const [a, b] = poses.map((pose) => ({ from: pose, to: pose }));
  assert.ok(pelt.collideMoving(a, b).count >= count);
  const search = pelt.makeSearch(...poses, { order: 'contacts' });
  search.run(Infinity);
  search.delete();
  const filter = poses[0].character.makeSelfFilter({ rings: 1, atRest: new Uint32Array([0, 1]) });
  pelt.selfCollide(poses[0], filter);
  pelt.describeSelfContacts(poses[0], Uint32Array.of());
  for (const pose of poses) {
    pose.normals();
    pose.nodeBoxes(1);
    pose.exactBounds();
  }
  const crowd = pelt.makeCrowd();
  const hash = pelt.makeContactHash();
  for (const { character } of scene.instances) crowd.add(scene.characters[character]);
  if (poses[0].character === poses[1].character) crowd.setSelfFilter(0, filter);
  hash.addCrowd(0, crowd.collide().contacts);
  for (const made of [filter, crowd, hash, ...poses, scene]) made.delete();
  refuseBroken();
}

/** The second scene is refused when a model has been read, and the third when one has been prepared. */
function refuseBroken() {
  const half = rock().subarray(0, 300);
  const refused = (use, message) => assert.throws(use, { name: 'PeltError', message });
  refused(() => pelt.readCharacter(half, { name: 'half' }), /^half: /);
  refused(() => pelt.readScene('scenes/rocks.json', { ...kFiles, 'models/rock.gltf': half }),
          /models\.rock: .*the JSON text is invalid/);
  refused(() => pelt.readScene('scenes/two.json', { ...kFiles, 'models/half.gltf': half }),
          /models\.zero: .*the JSON text is invalid/);
  const light = skinnedRock({ weight: 0.5 });
  refused(() => pelt.readScene('scenes/two.json', { ...kFiles, 'models/half.gltf': light }),
          /weights of vertex 0 sum to 0\.5/);
}

test('the engine uses no more memory after many scenes than after one', () => {
  for (let i = 0; i < 3; ++i) useEverything();
  const before = bytesInUse();
  for (let i = 0; i < 50; ++i) useEverything();
  assert.ok(bytesInUse() - before < 1024, `${bytesInUse() - before} bytes more`);
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

v8.setFlagsFromString('--expose-gc');
const collectGarbage = vm.runInNewContext('gc');
const nextTurn = () => new Promise((resolve) => setTimeout(resolve, 1));

function useAndForget() {
  const face = pelt.generateFace({ triangles: 1000 });
  const [a, b] = [face.makePose(), face.makePose()];
  pelt.collide(a, b);
  pelt.makeSearch(a, b).run(Infinity);
  pelt.selfCollide(a, face.makeSelfFilter());
  const crowd = pelt.makeCrowd();
  crowd.add(face);
  crowd.collide();
  pelt.makeContactHash();
  pelt.makeContactTally().add(pelt.selfCollide(a, face.makeSelfFilter()).pairs);
}

test('characters, poses, filters, searches, crowds and hashes that are forgotten are given back', async () => {
  useAndForget();
  for (let turn = 0; turn < 20; ++turn) {
    collectGarbage();
    await nextTurn();
  }
  const before = bytesInUse();
  for (let i = 0; i < 5; ++i) useAndForget();
  assert.ok(bytesInUse() > before + 200_000, `${bytesInUse() - before} bytes are not enough`);
  for (let turn = 0; turn < 1000 && bytesInUse() > before; ++turn) {
    collectGarbage();
    await nextTurn();
  }
  assert.ok(bytesInUse() - before < 1024, `${bytesInUse() - before} bytes are kept`);
});
