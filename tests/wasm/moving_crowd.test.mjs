/** Steps of crowds, and of a character against itself: as the command and the queries of poses find them. */

import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import test from 'node:test';
import { rocks } from './gltf.mjs';
import {
  bodiesOf,
  jsonLines,
  kFaces,
  kScenes,
  pelt,
  readSceneFile,
  refused,
  withFolder,
} from './support.mjs';

const rowsOf = (numbers, width) =>
  Array.from({ length: numbers.length / width }, (_, i) => Array.from(numbers.subarray(width * i, width * (i + 1))));

/** A crowd of the bodies; with rings, each is tested against itself, and parts are filtered. */
function makeCrowd(scene, bodies, rings) {
  const crowd = pelt.makeCrowd();
  const characterOf = (instance) => scene.characters[scene.instances[instance].character];
  for (const { instance, part } of bodies) {
    const number = crowd.add(characterOf(instance), part);
    if (rings !== null) crowd.setSelfFilter(number, characterOf(instance).makeSelfFilter({ rings }, part));
  }
  crowd.ignore(scene.ignore);
  if (rings === null || bodies[0].part === null) return crowd;
  scene.instances.forEach((_, instance) => {
    const own = bodies.flatMap((body, i) => (body.instance === instance ? [i] : []));
    crowd.filterParts(own, characterOf(instance).makeSelfFilter({ rings }));
  });
  return crowd;
}

/** Contacts of all steps at neither end, their hash and the first time of each step. */
function runSteps(scene, { byPart = false, rings = null, begin = 0 } = {}) {
  const bodies = bodiesOf(scene, byPart);
  const crowd = makeCrowd(scene, bodies, rings);
  const hash = pelt.makeContactHash();
  const pose = (frame) =>
    bodies.forEach(({ instance }, i) => {
      crowd.setPalette(i, scene.palette(instance, frame));
      crowd.setMorphWeights(i, scene.morphWeights(instance, frame));
    });
  let contacts = 0;
  const firsts = new Map();
  pose(begin);
  for (let frame = begin; frame + 1 < scene.frameCount; ++frame) {
    crowd.beginStep();
    pose(frame + 1);
    const moving = crowd.collideMoving({ leaveOutStart: true });
    const atEnd = new Set(rowsOf(crowd.collide().contacts, 4).map(String));
    const between = rowsOf(moving.contacts, 4)
      .map((row, i) => ({ row, time: moving.times[i] }))
      .filter(({ row }) => !atEnd.has(String(row)));
    assert.equal(moving.features.length, 4 * moving.count);
    if (between.length === 0) continue;
    contacts += between.length;
    hash.addCrowd(frame, Uint32Array.from(between.flatMap(({ row }) => row)));
    firsts.set(frame, (frame + Math.min(...between.map(({ time }) => time))) / scene.fps);
  }
  const found = { contacts, hash: hash.value, firsts };
  for (const made of [crowd, hash]) made.delete();
  return found;
}

/** Compares with `pelt check --between`. */
function agrees(scene, file, options, ...words) {
  const lines = jsonLines('check', file, '--between', ...words);
  const { contacts, hash } = lines.at(-1).totals.between;
  const found = runSteps(scene, options);
  assert.deepEqual([found.contacts, found.hash], [contacts, hash]);
  const steps = lines.filter(({ step, only_between: count }) => step !== undefined && count > 0);
  assert.deepEqual([...found.firsts], steps.map(({ step, first }) => [step, first]));
  return contacts;
}

const kAllOfSelf = ['--self-at-rest', 'keep', '--self-near-joints', 'keep'];

for (const file of [kFaces, path.join(kScenes, 'passing_through.json')]) {
  test(`the steps of a crowd are those of the command: ${path.basename(file)}`, () => {
    const scene = readSceneFile(file);
    assert.ok(agrees(scene, file, {}) > 500);
    scene.delete();
  });
}

test('so are those of instances against themselves', () => {
  const file = path.join(kScenes, 'passing_through.json');
  const scene = readSceneFile(file);
  scene.frameCount = 30;
  const words = ['--self-rings', '2', ...kAllOfSelf, '--frames', '24:30'];
  const contacts = agrees(scene, file, { rings: 2, begin: 24 }, '--self', ...words);
  const pairs = runSteps(scene, { begin: 24 }).contacts;
  assert.ok(contacts > pairs && pairs > 100, `${pairs} of ${contacts} contacts are of pairs`);
  scene.delete();
});

const kCairns = {
  models: { cairn: 'cairn.gltf' },
  frames: { count: 24, fps: 3 },
  instances: [
    { model: 'cairn', clip: 'roll' },
    { model: 'cairn', clip: 'roll', start: 0.5, translation: [0.3, 0.15, 0.05], velocity: [-0.4, 0, 0] },
  ],
};

test('so are those of parts, without what is ignored', () => {
  const kCairn = rocks(['base', 'middle', 'top']);
  withFolder((folder) => {
    for (const ignore of [[], [['base', 'middle']]]) {
      const text = Buffer.from(JSON.stringify({ ...kCairns, ignore }));
      const file = path.join(folder, 'scene.json');
      fs.writeFileSync(file, text);
      fs.writeFileSync(path.join(folder, 'cairn.gltf'), kCairn);
      const scene = pelt.readScene('scene.json', { 'scene.json': text, 'cairn.gltf': kCairn });
      assert.ok(agrees(scene, file, { byPart: true }, '--by', 'part') > 0);
      const words = ['--by', 'part', '--self', '--self-rings', '1', ...kAllOfSelf];
      assert.ok(agrees(scene, file, { byPart: true, rings: 1 }, ...words) > 0);
      scene.delete();
    }
  });
});

test('contacts of parts of one character pass its filter', () => {
  const cairn = pelt.readCharacter(rocks(['base', 'middle', 'top']), { name: 'cairn' });
  for (const parts of [[0, 1, 2], [2, 0, 1]]) {
    const crowd = pelt.makeCrowd();
    for (const part of parts) crowd.add(cairn, part);
    const setStep = () =>
      parts.forEach((_, i) => crowd.setMotion(i, cairn.palette('roll', 0), cairn.palette('roll', 0.7)));
    setStep();
    const all = crowd.collideMoving();
    const dropped = [0, 1];
    crowd.filterParts([0, 1, 2], cairn.makeSelfFilter({ jointPairs: Uint16Array.from(dropped) }));
    const kept = crowd.collideMoving();
    const isKept = (row) => String(row.slice(2).map((t) => cairn.triangleJoints[t]).sort()) !== String(dropped);
    const rows = rowsOf(all.contacts, 4);
    assert.deepEqual(rowsOf(kept.contacts, 4), rows.filter(isKept));
    assert.deepEqual([...kept.times], [...all.times].filter((_, i) => isKept(rows[i])));
    assert.ok(kept.count > 0 && kept.leftOut.joints === all.count - kept.count && kept.leftOut.joints > 0);
    const first = crowd.collideMoving({ maxContacts: 1 });
    const pairs = new Set(rows.filter(isKept).map(([a, b]) => `${a} ${b}`));
    assert.ok(first.count === pairs.size && first.stats.cutShort);
    crowd.delete();
  }
  cairn.delete();
});

const creature = pelt.generateCreature({ triangles: 6000, joints: 30 });
const poses = [0.1, 0.5].map((time) => {
  const pose = creature.makePose();
  pose.setPalette(creature.palette('walk', time));
  return pose;
});
const [from, to] = poses;
const motion = { from, to };

test('a character against itself touches what its poses do, and what a crowd finds', () => {
  const filter = creature.makeSelfFilter({ rings: 2 });
  const moving = pelt.selfCollideMoving(motion, filter);
  const keys = rowsOf(moving.pairs, 2).map(String);
  const atStart = rowsOf(pelt.selfCollide(from, filter).pairs, 2).map(String);
  const atEnd = rowsOf(pelt.selfCollide(to, filter).pairs, 2).map(String);
  assert.ok(atStart.length + atEnd.length > 0 && moving.count > atStart.length);
  assert.deepEqual(keys.filter((_, i) => moving.atStart[i] === 1), atStart);
  assert.ok(atEnd.every((key) => keys.includes(key)));
  assert.ok(moving.leftOut.rings > 0 && moving.stats.doublePairs > 0);
  assert.equal(pelt.selfTouchesWhileMoving(motion, filter), true);
  const crowd = pelt.makeCrowd();
  crowd.setSelfFilter(crowd.add(creature), filter);
  crowd.setMotion(0, ...[0.1, 0.5].map((time) => creature.palette('walk', time)));
  const { contacts, times, features, leftOut } = crowd.collideMoving();
  assert.deepEqual(rowsOf(contacts, 4), rowsOf(moving.pairs, 2).map((pair) => [0, 0, ...pair]));
  assert.deepEqual([times, features, leftOut], [moving.times, moving.features, moving.leftOut]);
  for (const made of [crowd, filter]) made.delete();
});

test('a crowd without a step stands still, and options mean what they mean for two motions', () => {
  const crowd = pelt.makeCrowd();
  for (const instance of [0, 1]) crowd.add(creature);
  const palettes = [0.1, 0.5].map((time) => creature.palette('walk', time));
  palettes.forEach((palette, i) => crowd.setPalette(i, palette));
  crowd.beginStep();
  const still = crowd.collideMoving();
  assert.deepEqual(still.contacts, crowd.collide().contacts);
  assert.ok(still.count > 100 && still.atStart.every((flag) => flag === 1));
  assert.equal(crowd.collideMoving({ leaveOutStart: true }).count, 0);
  const plain = crowd.collideMoving({ times: false });
  assert.deepEqual(plain.contacts, still.contacts);
  assert.deepEqual([plain.times.length, plain.atStart.length, plain.features.length], [0, 0, 0]);
  const some = crowd.collideMoving({ maxContacts: 7 });
  assert.ok(some.count === 7 && some.stats.cutShort);
  crowd.delete();
});

test('wrong steps are refused with their names', () => {
  const crowd = pelt.makeCrowd();
  crowd.add(creature);
  const palette = creature.palette('walk', 0);
  refused(() => crowd.setMotion(0, palette, palette.slice(1)), /^to: expected \d+ numbers/);
  refused(() => crowd.setMotion(0, palette.slice(1), palette), /^from: expected \d+ numbers/);
  refused(() => crowd.setMotion(1, palette, palette), /the crowd has no instance 1/);
  refused(() => crowd.setMotion(0, palette, palette.map(() => NaN)), /nan/);
  refused(() => crowd.collideMoving({ firstContact: true }), /^unknown option "firstContact"/);
  crowd.ignore([['a', 'b']]);
  refused(() => crowd.collideMoving({ maxContacts: 1 }), /^a limit: cannot be combined/);
  const filter = creature.makeSelfFilter();
  refused(() => pelt.selfCollideMoving(from, filter), 'motion: expected { from, to }, found a Pose');
  refused(() => pelt.selfCollideMoving({ from }, filter), 'motion.to: expected a Pose, found nothing');
  refused(() => pelt.selfTouchesWhileMoving(motion, creature), /^filter: expected a SelfFilter/);
  const other = pelt.generateFace().makeSelfFilter();
  refused(() => pelt.selfCollideMoving(motion, other), /another character or part/);
  for (const made of [crowd, filter, other]) made.delete();
});
