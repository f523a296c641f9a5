/** Answers, hashes and counters of whole scenes are those of the command. */

import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import test from 'node:test';
import { filesOfScene, framesOf, kScenes, kShared, nativeTotals, pelt } from './support.mjs';

/** Contacts and hash as in tests/tools/golden_hash_test.cpp. */
const kGolden = [
  { folder: kScenes, scene: 'approaching', frames: '110:120', contacts: 365, hash: '8ed0d7896ec497d0' },
  { folder: kScenes, scene: 'passing_through', frames: '30:90:20', contacts: 1728, hash: '8544fb62786a6f33' },
  { folder: kScenes, scene: 'crowd', frames: '10:11', contacts: 5382, hash: 'b446516afc6427fc' },
  { folder: kScenes, scene: 'pile', frames: '0:30:15', contacts: 26471, hash: '2e9d2a0a5ac3029e' },
  { folder: `${kShared}/scenes`, scene: 'two_walkers', frames: '0:120', contacts: 1279, hash: '51d83e213bbe2c15' },
];

const kCounters = ['nodePairs', 'refits', 'posedVertices', 'trianglePairs', 'displacements'];

function addStats(sum, stats) {
  for (const counter of kCounters) sum[counter] = (sum[counter] ?? 0) + stats[counter];
}

function runScene(scene, frames) {
  const crowd = pelt.makeCrowd();
  const hash = pelt.makeContactHash();
  for (const { character } of scene.instances) crowd.add(scene.characters[character]);
  const work = {};
  let contacts = 0;
  for (const frame of frames) {
    scene.instances.forEach((_, i) => crowd.setPalette(i, scene.palette(i, frame)));
    const found = crowd.collide();
    hash.addCrowd(frame, found.contacts);
    addStats(work, found.stats);
    contacts += found.count;
  }
  const { value } = hash;
  hash.delete();
  crowd.delete();
  return { contacts, hash: value, work };
}

for (const golden of kGolden) {
  const file = path.join(golden.folder, `${golden.scene}.json`);
  const skip = !fs.existsSync(file) && `${file} is not there`;
  test(`${golden.scene} has the contacts and counters of the command`, { skip }, () => {
    const root = path.resolve(golden.folder, '..');
    const scene = pelt.readScene(path.relative(root, file), filesOfScene(file, root));
    assert.equal(scene.name, `${golden.scene}.json`);
    const run = runScene(scene, framesOf(golden.frames));
    scene.delete();
    assert.equal(run.contacts, golden.contacts);
    assert.equal(run.hash, golden.hash);
    const native = nativeTotals(file, golden.frames);
    assert.equal(native.hash, golden.hash);
    assert.equal(run.work.nodePairs, native.counters.node_pairs);
    assert.equal(run.work.refits, native.counters.refits);
    assert.equal(run.work.posedVertices, native.counters.posed_vertices);
    assert.equal(run.work.trianglePairs, native.counters.triangle_pairs);
  });
}

function demoPoses() {
  const scene = pelt.readScene('demo.json', {
    'demo.json': new TextEncoder().encode(pelt.demoScene),
  });
  const poses = scene.instances.map(({ character }) => scene.characters[character].makePose());
  const pose = (frame) => poses.forEach((p, i) => scene.setPose(p, i, frame));
  return { scene, poses, pose };
}

test('poses asked two by two answer as a crowd does, and eagerly too', () => {
  const { scene, poses, pose } = demoPoses();
  const hash = pelt.makeContactHash();
  const frames = framesOf('40:50:3');
  let demand = 0;
  let eager = 0;
  for (const frame of frames) {
    pose(frame);
    const found = pelt.collide(...poses);
    const rival = pelt.collideEagerly(...poses);
    hash.add(frame, 0, 1, found.pairs);
    assert.deepEqual(rival.pairs, found.pairs);
    assert.equal(pelt.intersects(...poses), found.count > 0);
    assert.equal(pelt.collide(...poses, { firstContact: true }).count, Math.min(found.count, 1));
    demand += found.stats.posedVertices;
    eager += rival.stats.posedVertices;
  }
  assert.equal(hash.value, runScene(scene, frames).hash);
  assert.ok(2 * demand < eager, `${demand} vertices on demand, ${eager} eagerly`);
  scene.delete();
});

test('a scene of one\'s own is posed as the same scene from a file', () => {
  const { scene } = demoPoses();
  const { characters, frameCount, fps } = scene;
  const own = pelt.makeScene({ characters, instances: scene.instances, frameCount, fps });
  assert.deepEqual(own.palette(1, 44), scene.palette(1, 44));
  own.instances[1].translation = [0, 0, 5];
  assert.notDeepEqual(own.palette(1, 44), scene.palette(1, 44));
  assert.deepEqual(scene.palette(1, 0), scene.palette(1, 0, new Float32Array(56 * 16)));
  scene.delete();
});

test('broken scenes are refused as the command refuses them', () => {
  const text = (json) => ({ 'scene.json': new TextEncoder().encode(JSON.stringify(json)) });
  const creature = { creature: { triangles: 1000, joints: 20 } };
  const refused = (json, message) =>
    assert.throws(() => pelt.readScene('scene.json', text(json)), { name: 'PeltError', message });
  refused({ models: { a: 'gone.glb' }, instances: [] },
          /^scene\.json: models\.a: gone\.glb: there is no such file: paths in a scene/);
  refused({ models: { a: creature }, instances: [{ model: 'b' }] },
          /^scene\.json: instances\[0\]\.model: "b" is not in "models"/);
  refused({ models: { a: creature }, instances: [{ model: 'a', clip: 'walks' }] },
          /has no clip "walks".*walk/);
  refused({ models: { a: creature }, instances: [], extra: 1 }, /unknown key "extra"/);
  assert.throws(() => pelt.readScene('scene.json', { 'scene.json': new Uint8Array([0x7b, 0x22]) }),
                /the JSON text is wrong/);
  assert.throws(() => pelt.readScene('other.json', {}), /there is no such file/);
});
