/** Morph targets: generated faces, and the weights that poses and scenes have. */

import assert from 'node:assert/strict';
import test from 'node:test';
import { kFaces, pelt, posedByCommand, readSceneFile } from './support.mjs';

const kTargets = ['jaw_open', 'smile', 'blink_l', 'blink_r', 'brows_up', 'cheeks_puffed'];

const scene = readSceneFile(kFaces);
const face = pelt.generateFace({ triangles: 2000, seed: 3, name: 'sphinx' });

function posesOf(frame) {
  return scene.instances.map(({ character }, i) => {
    const pose = scene.characters[character].makePose();
    scene.setPose(pose, i, frame);
    return pose;
  });
}

function largest(a, b) {
  return a.reduce((most, x, i) => Math.max(most, Math.abs(x - b[i])), 0);
}

test('a generated face is what was asked for', () => {
  assert.equal(face.name, 'sphinx');
  assert.equal(face.triangleCount, 2000);
  assert.deepEqual(face.morphTargetNames, kTargets);
  assert.deepEqual(
    face.clips.map(({ name }) => name),
    ['talk'],
  );
  const other = pelt.generateFace({ triangles: 2000, seed: 4 });
  assert.equal(other.name, 'face');
  assert.notDeepEqual(other.restPositions, face.restPositions);
  other.delete();
  assert.throws(() => pelt.generateFace({ triangles: 200_001 }), {
    code: 'invalid_argument',
    message: /triangles/,
  });
});

test('faces are posed to the same bits as natively', () => {
  for (const frame of [0, 7, 31]) {
    const native = posedByCommand(kFaces, '--frame', `${frame}`);
    assert.equal(native.length, 3);
    posesOf(frame).forEach((pose, i) => assert.deepEqual(pose.posedVertices(), native[i]));
  }
});

test('faces asked two by two answer eagerly as on demand', () => {
  let contacts = 0;
  for (const frame of [0, 20, 47]) {
    const [a, b] = posesOf(frame);
    const found = pelt.collide(a, b);
    assert.deepEqual(pelt.collideEagerly(a, b).pairs, found.pairs);
    assert.ok(found.stats.displacements > 0);
    contacts += found.count;
  }
  assert.ok(contacts > 100, `${contacts} contacts`);
});

test('a pose moves by its weights, each target in proportion', () => {
  const pose = face.makePose();
  const rest = pose.posedVertices();
  const displaced = (weight) => {
    pose.setMorphWeights(Float32Array.of(weight, 0, 0, 0, 0, 0));
    return pose.posedVertices();
  };
  const [half, whole] = [displaced(0.5), displaced(1)];
  assert.ok(largest(whole, rest) > 0.001);
  assert.ok(
    largest(
      half.map((x, i) => 2 * (x - rest[i])),
      whole.map((x, i) => x - rest[i]),
    ) < 1e-5,
  );
  assert.deepEqual(displaced(0), rest);
  pose.delete();
});

test('weights that break a rule are refused and leave the pose as it was', () => {
  const pose = face.makePose();
  pose.setMorphWeights(face.morphWeights('talk', 0.4));
  const before = pose.posedVertices();
  assert.throws(
    () => pose.setMorphWeights(new Float32Array(5)),
    /weights: expected 6 numbers, found 5/,
  );
  const bad = Float32Array.of(0, 0, 0, 0, NaN, 0);
  assert.throws(() => pose.setMorphWeights(bad), { code: 'invalid_argument', message: /nan/ });
  assert.deepEqual(pose.posedVertices(), before);
  const crowd = pelt.makeCrowd();
  crowd.add(face);
  assert.throws(() => crowd.setMorphWeights(0, bad), { code: 'invalid_argument', message: /nan/ });
  assert.throws(() => crowd.setMorphWeights(1, bad), /the crowd has no instance 1/);
  crowd.delete();
  pose.delete();
});

test('weights come from the clip, but for those that an instance keeps', () => {
  const of = (i, frame) => Array.from(scene.morphWeights(i, frame));
  const { fps, instances } = scene;
  const [talker, listener] = scene.characters;
  const seconds = 9 / fps;
  assert.deepEqual(scene.morphWeights(0, 9), talker.morphWeights('talk', seconds));
  const ofClip = Array.from(
    listener.morphWeights('talk', instances[1].start + instances[1].speed * seconds),
  );
  const kept = ofClip.map(
    (weight, m) => ({ smile: -0.25, cheeks_puffed: Math.fround(0.8) })[kTargets[m]] ?? weight,
  );
  assert.ok(largest(of(1, 9), kept) < 1e-6);
  assert.deepEqual(of(2, 9), [0.75, 0, 0, 0, 0, 0]);
  const out = new Float32Array(6);
  assert.equal(face.morphWeights('talk', 0.4, out), out);
  assert.ok(out.some((weight) => weight !== 0));
  assert.deepEqual(Array.from(face.morphWeights(null, 0)), [0, 0, 0, 0, 0, 0]);
});

test('kept weights may be changed, by name or by number', () => {
  const own = pelt.makeScene({
    characters: [face],
    instances: [{ character: 0, morphWeights: { smile: 0.5 } }],
  });
  assert.deepEqual(Array.from(own.morphWeights(0, 0)), [0, 0.5, 0, 0, 0, 0]);
  own.instances[0].morphWeights = { 5: 0.25 };
  assert.deepEqual(Array.from(own.morphWeights(0, 0)), [0, 0, 0, 0, 0, 0.25]);
  own.instances[0].morphWeights = { frown: 1 };
  assert.throws(() => own.morphWeights(0, 0), /there is no morph target "frown"/);
});
