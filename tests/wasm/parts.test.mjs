/** Parts of instances collide as `pelt check --by part` has them, and what is ignored does not count. */

import assert from 'node:assert/strict';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import test from 'node:test';
import { rocks } from './gltf.mjs';
import { bodiesOf, pelt, runCommand } from './support.mjs';

const kScene = {
  models: { cairn: 'cairn.gltf' },
  frames: { count: 6, fps: 6 },
  instances: [
    { model: 'cairn', clip: 'roll' },
    { model: 'cairn', clip: 'roll', start: 0.5, translation: [0.1, 0.15, 0.05] },
  ],
};
const kCairn = rocks(['base', 'middle', 'top']);

function filesOf(scene) {
  return { 'scene.json': Buffer.from(JSON.stringify(scene)), 'cairn.gltf': kCairn };
}

/** The totals of `pelt check`. */
function native(scene, ...options) {
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'pelt-'));
  try {
    for (const [name, bytes] of Object.entries(filesOf(scene)))
      fs.writeFileSync(path.join(folder, name), bytes);
    const { out, err } = runCommand('check', path.join(folder, 'scene.json'), '--jsonl', '-', ...options);
    assert.equal(err.includes('error'), false, err);
    return JSON.parse(out.trim().split('\n').at(-1));
  } finally {
    fs.rmSync(folder, { recursive: true });
  }
}

/** Contacts, ignored ones and the hash of all frames. */
function run(scene, byPart) {
  const bodies = bodiesOf(scene, byPart);
  const crowd = pelt.makeCrowd();
  const hash = pelt.makeContactHash();
  for (const { instance, part } of bodies)
    crowd.add(scene.characters[scene.instances[instance].character], part);
  crowd.ignore(scene.ignore);
  const totals = { contacts: 0, ignored: 0 };
  for (let frame = 0; frame < scene.frameCount; ++frame) {
    bodies.forEach(({ instance }, i) => crowd.setPalette(i, scene.palette(instance, frame)));
    const { contacts, count, ignored } = crowd.collide();
    hash.addCrowd(frame, contacts);
    totals.contacts += count;
    totals.ignored += ignored;
  }
  const found = { ...totals, hash: hash.value };
  crowd.delete();
  hash.delete();
  return found;
}

function agrees(scene, by) {
  const read = pelt.readScene('scene.json', filesOf(scene));
  const found = run(read, by === 'part');
  const { totals, hash } = native(scene, '--by', by);
  read.delete();
  assert.deepEqual(found, { contacts: totals.contacts, ignored: totals.ignored, hash });
  assert.ok(found.contacts > 0);
  return found;
}

test('parts of one instance collide with each other, and with those of others', () => {
  const parts = agrees(kScene, 'part');
  const instances = agrees(kScene, 'instance');
  assert.ok(parts.contacts > instances.contacts);
});

test('what a scene ignores does not count, by part or by joint, and is counted apart', () => {
  const ignoring = { ...kScene, ignore: [['base', 'm*'], ['cairn/top', 'top']] };
  for (const by of ['instance', 'part']) {
    const [all, some] = [agrees(kScene, by), agrees(ignoring, by)];
    assert.ok(some.ignored > 0);
    assert.equal(some.contacts + some.ignored, all.contacts);
    assert.notEqual(some.hash, all.hash);
  }
});

test('poses of parts answer as the crowd does, with triangles numbered as the whole', () => {
  const scene = pelt.readScene('scene.json', filesOf(kScene));
  const bodies = bodiesOf(scene, true);
  const poses = bodies.map(({ instance, part }) =>
    scene.characters[scene.instances[instance].character].makePose(part),
  );
  const hash = pelt.makeContactHash();
  for (let frame = 0; frame < scene.frameCount; ++frame) {
    poses.forEach((pose, i) => scene.setPose(pose, bodies[i].instance, frame));
    poses.forEach((pose, a) =>
      poses.slice(a + 1).forEach((other, i) => {
        const { pairs, count } = pelt.collide(pose, other);
        hash.add(frame, a, a + 1 + i, pairs);
        const eager = pelt.collideEagerly(pose, other);
        assert.deepEqual(eager.pairs, pairs);
        assert.equal(pelt.describeContacts(pose, other, pairs).kinds.length, count);
      }),
    );
  }
  assert.equal(hash.value, run(scene, true).hash);
  const [first, second] = poses;
  assert.deepEqual([first.part, second.part], [0, 1]);
  assert.equal(first.posedVertices().length, 3 * first.character.vertexCount);
  assert.ok(first.nodeCount < first.character.nodeCount || first.character.nodeCount === 1);
  scene.delete();
});

test('a part that there is not is refused', () => {
  const scene = pelt.readScene('scene.json', filesOf(kScene));
  const [cairn] = scene.characters;
  for (const part of [3, -1, 0.5, 'base']) {
    assert.throws(() => cairn.makePose(part), { name: 'PeltError', message: /part/ });
    const crowd = pelt.makeCrowd();
    assert.throws(() => crowd.add(cairn, part), { name: 'PeltError', message: /part/ });
    crowd.delete();
  }
  scene.delete();
});

test('a name that nothing has is refused, unless it may have been left out', () => {
  const misspelt = filesOf({ ...kScene, ignore: [['bsae', 'top']] });
  assert.throws(() => pelt.readScene('scene.json', misspelt), {
    name: 'PeltError',
    message: /scene\.json: ignore: .*"bsae".*base/,
  });
  const scene = pelt.readScene('scene.json', misspelt, { exclude: ['top'] });
  assert.deepEqual(scene.ignore, [['bsae', 'top']]);
  scene.delete();
});

test('contacts of other queries lose those that do not count', () => {
  const scene = pelt.readScene('scene.json', filesOf({ ...kScene, ignore: [['base', 'top']] }));
  const crowd = pelt.makeCrowd();
  scene.instances.forEach(({ character }, i) => {
    crowd.add(scene.characters[character]);
    crowd.setPalette(i, scene.palette(i, 0));
  });
  const all = crowd.collide();
  crowd.ignore(scene.ignore);
  const { contacts, ignored } = crowd.collide();
  assert.ok(ignored > 0 && contacts.length > 0, 'a scene worth testing');
  const counted = crowd.withoutIgnored(all.contacts);
  assert.deepEqual(counted, { contacts, ignored });
  assert.deepEqual(crowd.withoutIgnored(new Uint32Array()), { contacts: new Uint32Array(), ignored: 0 });
  const { triangleCount } = scene.characters[0];
  for (const [row, message] of [
    [[0, 9, 0, 0], /the crowd has no instance 9/],
    [[0, 1, triangleCount, 0], /^PeltError: contacts\[2\]: expected a whole number from 0 to/],
    [[0, 1, 0], /contacts/],
  ])
    assert.throws(() => crowd.withoutIgnored(Uint32Array.from(row)), message);
  crowd.delete();
  scene.delete();
});

test('first contacts are not asked for where some do not count', () => {
  const scene = pelt.readScene('scene.json', filesOf({ ...kScene, ignore: [['base', 'top']] }));
  const crowd = pelt.makeCrowd();
  for (const { character } of scene.instances) crowd.add(scene.characters[character]);
  crowd.ignore(scene.ignore);
  assert.throws(() => crowd.collide({ firstContact: true }), /ignore/);
  crowd.ignore([]);
  assert.ok(crowd.collide({ firstContact: true }).count <= 1);
  for (const pairs of ['base,top', [['base']], [['base', 1]]])
    assert.throws(() => crowd.ignore(pairs), { name: 'PeltError', message: /ignore/ });
  crowd.delete();
  scene.delete();
});
