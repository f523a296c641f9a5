/** Characters with dual quaternion skinning answer as with the command. */

import assert from 'node:assert/strict';
import test from 'node:test';
import { fileURLToPath } from 'node:url';
import { contactsOf, nativeTotals, pelt, posedByCommand, readSceneFile } from './support.mjs';

const kDual = { skinning: 'dual-quaternion' };
const kScene = fileURLToPath(new URL('dual.json', import.meta.url));
const kFrames = 24;

/** The contacts of all frames of the scene, from palettes that are handed over. */
function totals(options = undefined) {
  const scene = readSceneFile(kScene, options);
  const crowd = pelt.makeCrowd();
  const hash = pelt.makeContactHash();
  for (const { character } of scene.instances) crowd.add(scene.characters[character]);
  let contacts = 0;
  for (let frame = 0; frame < kFrames; ++frame) {
    scene.instances.forEach((_, i) => crowd.setPalette(i, scene.palette(i, frame)));
    const found = crowd.collide();
    hash.addCrowd(frame, found.contacts);
    contacts += found.count;
  }
  const { value } = hash;
  scene.delete();
  return { contacts, hash: value };
}

function native(...options) {
  const { contacts, hash } = nativeTotals(kScene, `0:${kFrames}`, ...options);
  return { contacts, hash };
}

test('a scene chooses the skinning of its models, as for the command', () => {
  const found = totals();
  assert.deepEqual(found, native());
  assert.ok(found.contacts > 1000, `${found.contacts} contacts`);
});

test('an option replaces what the scene says, as for the command', () => {
  const dual = totals(kDual);
  const linear = totals({ skinning: 'linear' });
  assert.deepEqual(dual, native('--skinning', 'dual-quaternion'));
  assert.deepEqual(linear, native('--skinning', 'linear'));
  assert.equal(new Set([totals().hash, dual.hash, linear.hash]).size, 3);
});

test('an unknown kind of skinning is refused, with its place', () => {
  const model = { creature: { triangles: 1000 }, skinning: 'dual' };
  const scene = JSON.stringify({ models: { a: model }, instances: [{ model: 'a' }] });
  const files = { 'a.json': new TextEncoder().encode(scene) };
  assert.throws(
    () => pelt.readScene('a.json', files),
    /a\.json: models\.a\.skinning: expected "linear" or "dual-quaternion", found "dual"$/,
  );
  const change = (skinning) => () => pelt.generateCreature({ triangles: 1000, skinning });
  assert.throws(change('dual'), /skinning: expected one of "linear", "dual-quaternion", found "dual"$/);
});

/** x y z w of the rotation of a column-major matrix, for turns by less than 180 degrees. */
function quaternionOf(m) {
  const w = Math.sqrt(Math.max(0, 1 + m[0] + m[5] + m[10])) / 2;
  if (w > 0.1) return [(m[6] - m[9]) / (4 * w), (m[8] - m[2]) / (4 * w), (m[1] - m[4]) / (4 * w), w];
  const x = Math.sqrt(Math.max(0, 1 + m[0] - m[5] - m[10])) / 2;
  if (x > 0.1) return [x, (m[1] + m[4]) / (4 * x), (m[8] + m[2]) / (4 * x), (m[6] - m[9]) / (4 * x)];
  const y = Math.sqrt(Math.max(0, 1 - m[0] + m[5] - m[10])) / 2;
  if (y > 0.1) return [(m[1] + m[4]) / (4 * y), y, (m[6] + m[9]) / (4 * y), (m[8] - m[2]) / (4 * y)];
  const z = Math.sqrt(1 - m[0] - m[5] + m[10]) / 2;
  return [(m[8] + m[2]) / (4 * z), (m[6] + m[9]) / (4 * z), z, (m[1] - m[4]) / (4 * z)];
}

/** [J][8] dual quaternions of a palette. */
function dualQuaternionsOf(palette) {
  const duals = new Float32Array(palette.length / 2);
  for (let j = 0; 16 * j < palette.length; ++j) {
    const m = palette.subarray(16 * j, 16 * j + 16);
    const [x, y, z, w] = quaternionOf(m);
    const [a, b, c] = [m[12] / 2, m[13] / 2, m[14] / 2];
    const dual = [a * w + b * z - c * y, b * w + c * x - a * z, c * w + a * y - b * x];
    duals.set([x, y, z, w, ...dual, -(a * x + b * y + c * z)], 8 * j);
  }
  return duals;
}

/** Negates each third dual quaternion, which is the same motion. */
function negated(duals) {
  return duals.map((x, i) => (Math.floor(i / 8) % 3 === 0 ? -x : x));
}

test('dual quaternions of either sign pose as the matrices do', () => {
  const creature = pelt.generateCreature({ triangles: 3000, ...kDual });
  const linear = pelt.generateCreature({ triangles: 3000 });
  const [matrices, duals, others] = [1, 2, 3].map(() => creature.makePose());
  const blended = linear.makePose();
  let swell = 0;
  for (const seconds of [0.1, 0.4, 0.7]) {
    const palette = creature.palette('walk', seconds);
    matrices.setPalette(palette);
    blended.setPalette(palette);
    duals.setDualQuaternions(dualQuaternionsOf(palette));
    others.setDualQuaternions(negated(dualQuaternionsOf(palette)));
    const vertices = matrices.posedVertices();
    assert.deepEqual(others.posedVertices(), duals.posedVertices());
    const far = (pose) =>
      pose.posedVertices().reduce((most, x, i) => Math.max(most, Math.abs(x - vertices[i])), 0);
    assert.ok(far(duals) < 1e-5, `${far(duals)}`);
    swell = Math.max(swell, far(blended));
    const { count, pairs } = pelt.collide(duals, others);
    assert.ok(count > 1000, 'two copies in one place');
    assert.deepEqual(pelt.collideEagerly(duals, others).pairs, pairs);
  }
  assert.ok(swell > 1e-3, `linear blend skinning differs by ${swell} only`);
  const floats = dualQuaternionsOf(creature.palette('walk', 0));
  assert.throws(() => blended.setDualQuaternions(floats), /Skinning::dual_quaternion|dual-quaternion/);
  floats[8 * 5 + 3] += 1;
  assert.throws(() => duals.setDualQuaternions(floats), /\[5\]/);
});

test('a crowd is posed by dual quaternions, also in steps', () => {
  const creature = pelt.generateCreature({ triangles: 2000, ...kDual });
  const palettes = [0.1, 0.5, 0.3].map((seconds) => creature.palette('walk', seconds));
  const duals = palettes.map(dualQuaternionsOf);
  const poses = duals.map((floats) => {
    const pose = creature.makePose();
    pose.setDualQuaternions(floats);
    return pose;
  });
  const [a, b, end] = poses;
  const crowd = pelt.makeCrowd();
  for (const instance of [0, 1]) crowd.setDualQuaternions(crowd.add(creature), duals[instance]);
  const { count, contacts } = crowd.collide();
  assert.deepEqual([...contacts], contactsOf(pelt.collide(a, b).pairs));
  assert.ok(count > 500, `${count} contacts`);
  crowd.beginStep();
  crowd.setDualQuaternions(0, duals[2]);
  const still = creature.makePose();
  still.setDualQuaternions(duals[1]);
  const moving = pelt.collideMoving({ from: a, to: end }, { from: b, to: still });
  assert.deepEqual([...crowd.collideMoving().contacts], contactsOf(moving.pairs));
  assert.ok(moving.count > count);
  crowd.setMotionDualQuaternions(0, duals[2], duals[0]);
  const back = pelt.collideMoving({ from: end, to: a }, { from: b, to: still });
  assert.deepEqual([...crowd.collideMoving().contacts], contactsOf(back.pairs));

  const refused = (use, message) => assert.throws(use, { code: 'invalid_argument', message });
  refused(() => crowd.setDualQuaternions(0, palettes[0]), /^dualQuaternions: expected \d+ numbers/);
  refused(() => crowd.setDualQuaternions(2, duals[0]), /the crowd has no instance 2/);
  const wrong = duals[0].map((x, i) => (i === 8 * 5 + 3 ? x + 1 : x));
  refused(() => crowd.setDualQuaternions(0, wrong), /^dualQuaternions\[5\]/);
  refused(() => crowd.setMotionDualQuaternions(0, duals[0], wrong), /^dualQuaternions\[5\]/);
  refused(() => crowd.setMotionDualQuaternions(0, duals[0], palettes[0]), /^to: expected \d+ numbers/);
  for (const made of [crowd, ...poses, still, creature]) made.delete();
});

test('poses have the vertices of the command, bit for bit', () => {
  const scene = readSceneFile(kScene);
  const posed = posedByCommand(kScene, '--frame', '13');
  scene.instances.forEach(({ character }, i) => {
    const pose = scene.characters[character].makePose();
    scene.setPose(pose, i, 13);
    assert.deepEqual(pose.posedVertices(), posed[i]);
  });
});
