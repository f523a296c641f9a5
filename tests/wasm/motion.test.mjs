/** Motions: what touches between frames is what the command finds there. */

import assert from 'node:assert/strict';
import path from 'node:path';
import test from 'node:test';
import {
  FeatureKind,
  jsonLines,
  kFaces,
  kScenes,
  pelt,
  readSceneFile,
  refused,
} from './support.mjs';

const kKinds = Object.keys(FeatureKind);

const rowsOf = (numbers, width) =>
  Array.from({ length: numbers.length / width }, (_, i) => Array.from(numbers.subarray(width * i, width * (i + 1))));

/** Two poses of each instance, in which frames are posed in turn. */
function makeTurns(scene) {
  return scene.instances.map(({ character }) => [0, 1].map(() => scene.characters[character].makePose()));
}

function* pairsOf(count) {
  for (let a = 0; a < count; ++a) for (let b = a + 1; b < count; ++b) yield [a, b];
}

const featureOf = ([kind, number]) =>
  kind === FeatureKind.face ? { kind: 'face' } : { kind: kKinds[kind], number };

/** The contacts of a step at neither end, as `pelt check --between --pairs` writes them. */
function contactsBetween(scene, motions, a, b, frame) {
  const moving = pelt.collideMoving(motions[a], motions[b], { leaveOutStart: true });
  assert.ok(moving.atStart.every((flag) => flag === 0));
  const atEnd = new Set(rowsOf(pelt.collide(motions[a].to, motions[b].to).pairs, 2).map(String));
  const features = rowsOf(moving.features, 4);
  const between = rowsOf(moving.pairs, 2).map((triangles, i) => ({
    triangles,
    first: (frame + moving.times[i]) / scene.fps,
    features: [featureOf(features[i].slice(0, 2)), featureOf(features[i].slice(2))],
  }));
  return between.filter(({ triangles }) => !atEnd.has(String(triangles)));
}

/** The steps with contacts between their frames, and their hash. */
function runSteps(scene) {
  const hash = pelt.makeContactHash();
  const turns = makeTurns(scene);
  const setPoses = (frame) => turns.forEach((turn, i) => scene.setPose(turn[frame % 2], i, frame));
  const steps = new Map();
  setPoses(0);
  for (let frame = 0; frame + 1 < scene.frameCount; ++frame) {
    setPoses(frame + 1);
    const motions = turns.map((turn) => ({ from: turn[frame % 2], to: turn[(frame + 1) % 2] }));
    for (const [a, b] of pairsOf(motions.length)) {
      const between = contactsBetween(scene, motions, a, b, frame);
      if (between.length === 0) continue;
      hash.add(frame, a, b, Uint32Array.from(between.flatMap(({ triangles }) => triangles)));
      steps.set(frame, [...(steps.get(frame) ?? []), { a, b, between }]);
    }
  }
  const { value } = hash;
  hash.delete();
  turns.flat().forEach((pose) => pose.delete());
  return { hash: value, steps };
}

for (const file of [kFaces, ...['approaching', 'passing_through'].map((name) => path.join(kScenes, `${name}.json`))]) {
  test(`${path.basename(file)} has the contacts, times and hash of the command between its frames`, () => {
    const lines = jsonLines('check', file, '--between', '--pairs');
    const { contacts, hash } = lines.at(-1).totals.between;
    const scene = readSceneFile(file);
    const run = runSteps(scene);
    assert.equal(run.hash, hash);
    let found = 0;
    for (const { step, pairs } of lines.filter(({ step }) => step !== undefined)) {
      const native = pairs.map(({ a, b, between }) => ({ a, b, between }));
      assert.deepEqual(run.steps.get(step), native, `step ${step}`);
      found += native.reduce((sum, { between }) => sum + between.length, 0);
    }
    assert.equal(found, contacts);
    assert.ok(found > 500, `${found} contacts`);
    scene.delete();
  });
}

const scene = pelt.readScene('demo.json', {
  'demo.json': new TextEncoder().encode(pelt.demoScene),
});
const [a, b] = makeTurns(scene).map(([from, to], i) => {
  scene.setPose(from, i, 38);
  scene.setPose(to, i, 44);
  return { from, to };
});

test('the ends of a step are those of its poses', () => {
  const { pairs, times, atStart, count } = pelt.collideMoving(a, b);
  const keys = rowsOf(pairs, 2).map(String);
  const start = rowsOf(pelt.collide(a.from, b.from).pairs, 2).map(String);
  assert.deepEqual(keys.filter((_, i) => atStart[i] === 1), start);
  const all = new Set(keys);
  const end = rowsOf(pelt.collide(a.to, b.to).pairs, 2).map(String);
  assert.ok(end.length > 100 && end.every((key) => all.has(key)));
  assert.ok(count > end.length && times.every((time, i) => time >= 0 && time <= 1 && (atStart[i] === 0 || time === 0)));
});

test('the first contact is the earliest of all, and none is earlier', () => {
  for (const leaveOutStart of [false, true]) {
    const all = pelt.collideMoving(a, b, { leaveOutStart });
    const first = pelt.firstContact(a, b, { leaveOutStart });
    const index = all.times.indexOf(Math.min(...all.times));
    assert.equal(first.time, all.times[index]);
    const listed = rowsOf(all.pairs, 2).findIndex(
      ([triangleA, triangleB]) => triangleA === first.triangleA && triangleB === first.triangleB,
    );
    assert.equal(all.times[listed], first.time);
    assert.equal(all.atStart[listed] !== 0, first.atStart);
    const { featureA, featureB } = first;
    assert.deepEqual(
      [featureA.kind, featureA.number, featureB.kind, featureB.number],
      Array.from(all.features.subarray(4 * listed, 4 * listed + 4)),
    );
    assert.ok(first.stats.trianglePairs > 0);
  }
});

test('options leave out times and all beyond a limit', () => {
  const all = pelt.collideMoving(a, b);
  assert.ok(all.stats.doublePairs >= all.stats.exactPairs && all.stats.doublePairs > 0);
  const plain = pelt.collideMoving(a, b, { times: false });
  assert.deepEqual(plain.pairs, all.pairs);
  assert.deepEqual([plain.times.length, plain.atStart.length, plain.features.length], [0, 0, 0]);
  const some = pelt.collideMoving(a, b, { maxContacts: 7 });
  assert.ok(some.count === 7 && some.stats.cutShort);
  assert.equal(pelt.touchWhileMoving(a, b), true);
});

test('a motion far away touches nothing, and one that stands still touches what its pose does', () => {
  const character = a.from.character;
  const far = character.makePose();
  far.setPalette(character.palette(null, 0, [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 90, 0, 0, 1]));
  const away = { from: far, to: far };
  assert.equal(pelt.collideMoving(away, b).count, 0);
  assert.equal(pelt.touchWhileMoving(away, b), false);
  assert.equal(pelt.firstContact(away, b), null);
  far.delete();
  const [still, other] = [a, b].map(({ to }) => ({ from: to, to }));
  assert.deepEqual(pelt.collideMoving(still, other).pairs, pelt.collide(a.to, b.to).pairs);
});

test('parts have the triangle numbers of their character', () => {
  const part = b.from.character.makePose(0);
  part.setPalette(scene.palette(1, 44));
  const { pairs } = pelt.collideMoving({ from: a.to, to: a.to }, { from: part, to: part });
  assert.deepEqual(pairs, pelt.collide(a.to, part).pairs);
  part.delete();
});

test('wrong motions are refused with their names', () => {
  for (const name of ['collideMoving', 'touchWhileMoving', 'firstContact']) {
    const ask = (...motions) => () => pelt[name](...motions);
    refused(ask(a.from, b), 'a: expected { from, to }, found a Pose');
    refused(ask({}, b), 'a.from: expected a Pose, found nothing');
    refused(ask(a, null), 'b: expected an object, found null');
    refused(ask(a, { from: b.from }), 'b.to: expected a Pose, found nothing');
    refused(ask(a, { ...b, till: 1 }), /^b: unknown key "till"/);
    refused(ask({ from: a.from, to: b.to }, b), /^a: expected two poses of one character/);
    refused(ask(a, { from: a.to, to: a.to }), /^a and b: .* one pose in both motions$/);
  }
  refused(() => pelt.collideMoving(a, b, { firstContact: true }), /^unknown option "firstContact"/);
  refused(() => pelt.collideMoving(a, b, { times: 1 }), /^times: expected true or false/);
  refused(() => pelt.collideMoving(a, b, { maxContacts: 0 }), /^maxContacts: expected a whole number/);
  refused(() => pelt.firstContact(a, b, { times: true }), /^unknown option "times"/);
  const gone = a.from.character.makePose();
  gone.delete();
  refused(() => pelt.collideMoving({ from: gone, to: gone }, b), /has been deleted/);
});
