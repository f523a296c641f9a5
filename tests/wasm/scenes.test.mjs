/** Answers, hashes and counters of whole scenes are those of the command. */

import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import test from 'node:test';
import {
  framesOf,
  kFaces,
  kScenes,
  kShared,
  nativeTotals,
  pelt,
  posedByCommand,
  readSceneFile,
  withFolder,
} from './support.mjs';

/** Frames of scenes of which all would take too long. */
const kSomeFrames = { crowd: '0:30:10', pile: '0:30:10' };

/** Scenes have no offsets, so the command does not count clamped ones. */
function addTo(sum, { cutShort, clampedOffsets, ...counts }) {
  assert.deepEqual([cutShort, clampedOffsets], [false, 0]);
  for (const [counter, count] of Object.entries(counts)) sum[counter] = (sum[counter] ?? 0) + count;
}

/** Palettes and weights are computed here, and handed over. */
function runScene(scene, frames) {
  const crowd = pelt.makeCrowd();
  const hash = pelt.makeContactHash();
  for (const { character } of scene.instances) crowd.add(scene.characters[character]);
  const work = {};
  let contacts = 0;
  for (const frame of frames) {
    scene.instances.forEach((_, i) => {
      crowd.setPalette(i, scene.palette(i, frame));
      crowd.setMorphWeights(i, scene.morphWeights(i, frame));
    });
    const found = crowd.collide();
    hash.addCrowd(frame, found.contacts);
    addTo(work, found.stats);
    contacts += found.count;
  }
  const { value } = hash;
  hash.delete();
  crowd.delete();
  return { contacts, hash: value, work };
}

/** Compares the frames of a range, or all; returns what both have found. */
function compareScene(file, range = undefined) {
  const scene = readSceneFile(file);
  assert.equal(scene.name, path.basename(file));
  const frames = range ?? `0:${scene.frameCount}`;
  const run = runScene(scene, framesOf(frames));
  scene.delete();
  assert.deepEqual(run, nativeTotals(file, frames));
  assert.ok(run.contacts > 0);
  return run;
}

for (const file of fs.readdirSync(kScenes).filter((name) => name.endsWith('.json'))) {
  const name = path.basename(file, '.json');
  test(`${name} has the contacts and counters of the command`, () => {
    compareScene(path.join(kScenes, file), kSomeFrames[name]);
  });
}

test('faces with morph targets have the contacts and counters of the command', () => {
  const { work } = compareScene(kFaces);
  assert.ok(work.displacements > 1000, `${work.displacements} displacements`);
});

test('the demo has the contacts and counters of the command', () => {
  withFolder((folder) => {
    const file = path.join(folder, 'demo.json');
    fs.writeFileSync(file, pelt.demoScene);
    compareScene(file);
  });
});

const kWalkers = path.join(kShared, 'scenes/two_walkers.json');
const skipShared = !fs.existsSync(kWalkers) && `${kWalkers} is not there`;
test('two_walkers has the contacts and counters of the command', { skip: skipShared }, () => {
  assert.equal(compareScene(kWalkers, '0:120').hash, '51d83e213bbe2c15');
});

const demo = pelt.readScene('demo.json', {
  'demo.json': new TextEncoder().encode(pelt.demoScene),
});
const poses = demo.instances.map(({ character }) => demo.characters[character].makePose());

function poseDemo(frame) {
  poses.forEach((pose, i) => demo.setPose(pose, i, frame));
}

test('poses asked two by two answer as a crowd does, and eagerly too', () => {
  const hash = pelt.makeContactHash();
  const frames = framesOf('40:50:3');
  let demand = 0;
  let eager = 0;
  for (const frame of frames) {
    poseDemo(frame);
    const found = pelt.collide(...poses);
    const rival = pelt.collideEagerly(...poses);
    hash.add(frame, 0, 1, found.pairs);
    assert.deepEqual(rival.pairs, found.pairs);
    assert.equal(pelt.intersects(...poses), found.count > 0);
    assert.equal(pelt.collide(...poses, { firstContact: true }).count, Math.min(found.count, 1));
    demand += found.stats.posedVertices;
    eager += rival.stats.posedVertices;
  }
  assert.equal(hash.value, runScene(demo, frames).hash);
  assert.ok(2 * demand < eager, `${demand} vertices on demand, ${eager} eagerly`);
});

test('a pose is refitted once for its palette, or when it is told to', () => {
  poseDemo(44);
  const [a, b] = poses;
  const whole = a.openAll();
  assert.ok(whole.posedVertices >= a.character.vertexCount && whole.refits > 0);
  assert.deepEqual(a.openAll(), whole);
  const first = pelt.collideEagerly(a, b).stats;
  assert.ok(first.posedVertices > 0, 'the second one has not been refitted yet');
  assert.equal(first.posedVertices, b.openAll().posedVertices);
  assert.equal(pelt.collideEagerly(a, b).stats.posedVertices, 0);
  poseDemo(45);
  const { stats, pairs } = pelt.collideEagerly(a, b);
  assert.equal(stats.posedVertices, first.posedVertices + whole.posedVertices);
  assert.deepEqual(pairs, pelt.collide(a, b).pairs);
});

test('vertices and normals are of the palette that was set last', () => {
  const [pose] = poses;
  const shape = () => [pose.posedVertices(), pose.normals()];
  poseDemo(44);
  const before = shape();
  poseDemo(60);
  const [vertices, normals] = shape();
  assert.notDeepEqual(vertices, before[0]);
  poseDemo(44);
  assert.deepEqual(pose.normals(), before[1]);
  assert.deepEqual(pose.posedVertices(), before[0]);
  pose.setPalette(demo.palette(0, 60));
  assert.deepEqual(shape(), [vertices, normals]);
});

test('queries stop where they are told to', () => {
  poseDemo(44);
  const all = pelt.collide(...poses);
  assert.ok(all.count > 100 && !all.stats.cutShort);
  const known = new Set(
    Array.from({ length: all.count }, (_, i) => all.pairs.subarray(2 * i, 2 * i + 2).join()),
  );
  for (const maxContacts of [1, 7, all.count - 1]) {
    const some = pelt.collide(...poses, { maxContacts });
    assert.equal(some.count, maxContacts);
    assert.ok(some.stats.cutShort);
    for (let i = 0; i < some.count; ++i)
      assert.ok(known.has(some.pairs.subarray(2 * i, 2 * i + 2).join()));
  }
  assert.deepEqual(pelt.collide(...poses, { maxContacts: all.count + 1 }).pairs, all.pairs);

  const crowd = pelt.makeCrowd();
  for (let i = 0; i < 3; ++i) {
    const instance = i % 2;
    crowd.setPalette(crowd.add(poses[instance].character), demo.palette(instance, 44));
  }
  const { contacts } = crowd.collide({ maxContacts: 3 });
  const of = (a, b) =>
    contacts.filter((_, i) => i % 4 === 0 && contacts[i] === a && contacts[i + 1] === b).length;
  assert.deepEqual([of(0, 1), of(0, 2), of(1, 2)], [3, 3, 3]);
  assert.equal(crowd.collide({ firstContact: true }).count, 3);
  crowd.delete();
});

test("a scene of one's own is posed as the same scene from a file", () => {
  const { characters, instances, frameCount, fps } = demo;
  const own = pelt.makeScene({ characters, instances, frameCount, fps });
  assert.deepEqual(own.palette(1, 44), demo.palette(1, 44));
  own.instances[1].translation = [0, 0, 5];
  assert.notDeepEqual(own.palette(1, 44), demo.palette(1, 44));
  assert.deepEqual(demo.palette(1, 0), demo.palette(1, 0, new Float32Array(56 * 16)));
});

test('a scene has the choices of its file for contacts of characters with themselves', () => {
  const models = { a: { creature: { triangles: 1000, joints: 20 } } };
  const selfOf = (keys) => {
    const file = { models, instances: [{ model: 'a' }], ...keys };
    const scene = pelt.readScene('s.json', { 's.json': new TextEncoder().encode(JSON.stringify(file)) });
    const { characters, instances, self } = scene;
    assert.deepEqual(pelt.makeScene({ characters, instances, self }).self, self);
    scene.delete();
    return self;
  };
  assert.deepEqual(selfOf({}), {});
  for (const [value, wanted] of [[true, 'also'], [false, 'off'], ['only', 'only']]) {
    assert.deepEqual(selfOf({ self: value }), { wanted });
  }
  assert.deepEqual(
    selfOf({ self_rings: 2, self_at_rest: 'keep', self_always: 0.5, self_near_joints: 'drop' }),
    { rings: 2, dropsAtRest: false, always: 0.5, dropsNearJoints: true },
  );
  assert.deepEqual(selfOf({ self_always: 'keep' }), { always: null });
  const refused = (self, message) =>
    assert.throws(() => pelt.makeScene({ characters: [], self }), { name: 'PeltError', message });
  refused({ wanted: 'yes' }, /^parts\.self\.wanted: expected one of "off", "also", "only", found "yes"/);
  refused({ rings: 65 }, /^parts\.self\.rings: /);
  refused({ always: 0 }, /^parts\.self\.always: /);
  refused({ atRest: true }, /^parts\.self: unknown key "atRest"/);
});

test('broken scenes are refused as the command refuses them', () => {
  const text = (json) => ({ 'scene.json': new TextEncoder().encode(JSON.stringify(json)) });
  const creature = { creature: { triangles: 1000, joints: 20 } };
  const refused = (json, message) =>
    assert.throws(() => pelt.readScene('scene.json', text(json)), { name: 'PeltError', message });
  refused(
    { models: { a: 'gone.glb' }, instances: [] },
    /^scene\.json: models\.a: gone\.glb: there is no such file: paths in a scene/,
  );
  refused(
    { models: { a: creature }, instances: [{ model: 'b' }] },
    /^scene\.json: instances\[0\]\.model: "b" is not in "models"/,
  );
  refused(
    { models: { a: creature }, instances: [{ model: 'a', clip: 'walks' }] },
    /has no clip "walks".*walk/,
  );
  refused(
    { models: { a: creature }, instances: [{ model: 'a', clip: '*' }] },
    /^scene\.json: only the command can play all clips with "\*": name one clip$/,
  );
  refused({ models: { a: creature }, instances: [], extra: 1 }, /unknown key "extra"/);
  assert.throws(
    () => pelt.readScene('scene.json', { 'scene.json': new Uint8Array([0x7b, 0x22]) }),
    /the JSON text is invalid/,
  );
  assert.throws(() => pelt.readScene('other.json', {}), /there is no such file/);
});
