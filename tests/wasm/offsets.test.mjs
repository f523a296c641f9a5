/** Offsets that are added to posed vertices, under caps. */

import assert from 'node:assert/strict';
import test from 'node:test';
import { rock } from './gltf.mjs';
import { bytesInUse, contactsOf, pelt, refused } from './support.mjs';

const kCap = 0.03;
const kCreature = { triangles: 4000, joints: 30 };
const plain = pelt.generateCreature(kCreature);
const capped = pelt.generateCreature({ ...kCreature, offsetCaps: kCap });

/** Offsets of all vertices that are within `size` and differ by seed. */
function wrinkles(seed, size = kCap) {
  return plain.restPositions.map((_, i) => size * Math.sin(12.9898 * (i + 1) + 78.233 * seed));
}

function posed(seconds, offsets, character = capped) {
  const pose = character.makePose();
  pose.setPalette(character.palette('walk', seconds));
  if (offsets) pose.setOffsets(offsets);
  return pose;
}

/** A pose of the character without caps that has the vertices of a pose. */
function given(pose) {
  const copy = plain.makePose();
  copy.setVertices(pose.posedVertices());
  return copy;
}

const sum = (vertices, offsets) => vertices.map((x, i) => x + offsets[i]);

test('posed vertices are those of the joints plus the offsets', () => {
  const offsets = wrinkles(1);
  const pose = posed(0.3, offsets);
  const joints = posed(0.3, null, plain).posedVertices();
  assert.deepEqual(pose.posedVertices(), sum(joints, offsets));
  assert.equal(pose.checkOffsets(), 0);
  const copy = offsets.slice();
  offsets.fill(NaN);
  pose.setPalette(capped.palette('walk', 0.5)); // offsets remain
  assert.deepEqual(pose.posedVertices(), sum(posed(0.5, null, plain).posedVertices(), copy));
  pose.setOffsets(wrinkles(2));
  pose.setOffsets(null);
  assert.deepEqual(pose.posedVertices(), posed(0.5, null, plain).posedVertices());
  pose.delete();
});

test('queries answer as for poses with these vertices', () => {
  const poses = [0.1, 0.5, 0.2, 0.6].map((seconds, i) => posed(seconds, wrinkles(i)));
  const copies = poses.map(given);
  const answersOf = ([a, aTo, b, bTo]) => {
    const { pairs } = pelt.collide(a, b);
    const filter = a.character.makeSelfFilter({ rings: 2 });
    const motions = [{ from: a, to: aTo }, { from: b, to: bTo }];
    const moving = pelt.collideMoving(...motions);
    const answers = {
      pairs,
      eager: pelt.collideEagerly(a, b).pairs,
      segments: pelt.describeContacts(a, b, pairs).segments,
      near: pelt.clearance(a, b, 0.01).pairs,
      hits: a.castAll([0, 0.9, 9], [0.01, 0, -1]),
      self: pelt.selfCollide(a, filter).pairs,
      moving: [moving.pairs, moving.times],
      box: a.exactBounds().box,
      normals: a.normals(),
    };
    filter.delete();
    return answers;
  };
  const answers = answersOf(poses);
  assert.ok(answers.pairs.length > 1000 && answers.self.length > 0 && answers.hits.length > 0);
  assert.deepEqual(answers, answersOf(copies));
  const bare = [0.1, 0.2].map((seconds) => posed(seconds, null));
  assert.notDeepEqual(pelt.collide(...bare).pairs, answers.pairs);
  for (const pose of [...poses, ...copies, ...bare]) pose.delete();
});

test('boxes enclose all that caps allow, without posing vertices', () => {
  const pose = posed(0.3, wrinkles(1));
  const { box } = pose.bounds();
  assert.equal(pelt.lastStats.posedVertices, 0);
  const cap = Math.fround(kCap);
  for (const sign of [-1, 1]) {
    pose.setOffsets(new Float32Array(3 * capped.vertexCount).fill(sign * cap));
    const { low, high } = pose.exactBounds().box;
    for (let axis = 0; axis < 3; ++axis) assert.ok(box.low[axis] <= low[axis] && high[axis] <= box.high[axis]);
  }
  pose.delete();
});

test('offsets beyond their caps are clamped and counted', () => {
  const size = 2 * kCap;
  const offsets = wrinkles(3, size);
  offsets[3 * 5] = NaN;
  const cap = Math.fround(kCap);
  const clamp = (x) => (Number.isNaN(x) ? 0 : Math.min(Math.max(x, -cap), cap));
  const isClamped = (v) => [0, 1, 2].some((i) => !(Math.abs(offsets[3 * v + i]) <= cap));
  const clamped = Array.from({ length: capped.vertexCount }, (_, v) => isClamped(v)).filter(Boolean).length;
  assert.ok(clamped > 1000 && clamped < capped.vertexCount, `${clamped} vertices`);
  const [pose, other] = [posed(0.3, offsets), posed(0.4, wrinkles(4))];
  assert.equal(pose.checkOffsets(), clamped);
  const joints = posed(0.3, null, plain).posedVertices();
  assert.deepEqual(pose.posedVertices(), sum(joints, offsets.map(clamp)));
  const { clampedOffsets, posedVertices } = pelt.collide(pose, other).stats;
  assert.ok(clampedOffsets > 0 && clampedOffsets < posedVertices, `${clampedOffsets} clamped`);
  assert.equal(pelt.lastStats.clampedOffsets, clampedOffsets);
  assert.ok(pose.openAll().clampedOffsets >= clamped);
  assert.equal(other.openAll().clampedOffsets, 0);
  for (const made of [pose, other]) made.delete();
});

test('caps may differ by vertex', () => {
  const { restPositions, triangles } = plain;
  const offsetCaps = Float32Array.from({ length: plain.vertexCount }, (_, v) => (v % 3) / 64);
  const pose = pelt.makeCharacter({ restPositions, triangles, offsetCaps }).makePose();
  pose.setOffsets(new Float32Array(restPositions.length).fill(1));
  assert.deepEqual(pose.posedVertices(), restPositions.map((x, i) => x + offsetCaps[Math.floor(i / 3)]));
  assert.equal(pose.checkOffsets(), plain.vertexCount);
  const stone = pelt.readCharacter(rock(), { name: 'rock', offsetCaps: Float32Array.of(0, 1, 0, 0) });
  const thrown = stone.makePose(0);
  thrown.setOffsets(new Float32Array(12).fill(0.5));
  assert.deepEqual(thrown.posedVertices(), stone.restPositions.map((x, i) => (i < 3 || i > 5 ? x : x + 0.5)));
  for (const made of [pose, thrown, stone]) made.delete();
});

test('each pose has memory of its own, which is freed with it', () => {
  const before = bytesInUse();
  const poses = [1, 2, 3].map((seed) => posed(0.3, wrinkles(seed)));
  const copies = poses.map((pose) => pose.posedVertices());
  poses[1].setOffsets(wrinkles(7));
  assert.deepEqual([poses[0].posedVertices(), poses[2].posedVertices()], [copies[0], copies[2]]);
  assert.ok(bytesInUse() > before + 3 * 12 * capped.vertexCount);
  for (const pose of poses) pose.delete();
  assert.equal(bytesInUse(), before);
});

/** The moving contacts of two instances that go from vertices to others. */
function movingContacts(...[from, to, other, end]) {
  const { pairs, times, count } = pelt.collideMoving({ from, to }, { from: other, to: end });
  assert.ok(count > 500, `${count} contacts`);
  return [contactsOf(pairs), times];
}

test('crowds borrow offsets for as long as a step lasts', () => {
  const crowd = pelt.makeCrowd();
  const times = [0.1, 0.2];
  const poseAt = (i, seed) => posed(times[i], wrinkles(seed));
  const isStep = (...seeds) => {
    const poses = seeds.map((seed, end) => poseAt(end < 2 ? 0 : 1, seed));
    const { contacts, times: found } = crowd.collideMoving();
    assert.deepEqual([[...contacts], found], movingContacts(...poses));
    assert.deepEqual([...crowd.collide().contacts], contactsOf(pelt.collide(poses[1], poses[3]).pairs));
    for (const pose of poses) pose.delete();
  };
  times.forEach((seconds) => crowd.setPalette(crowd.add(capped), capped.palette('walk', seconds)));
  crowd.setOffsets(0, wrinkles(9));
  crowd.setOffsets(0, wrinkles(1));
  crowd.setOffsets(1, wrinkles(2));
  for (let i = 0; i < 40; ++i) crowd.setPalette(crowd.add(plain), placedAside(i));
  crowd.beginStep();
  crowd.setOffsets(0, wrinkles(8));
  crowd.setOffsets(0, wrinkles(3));
  crowd.setOffsets(1, wrinkles(4));
  isStep(1, 3, 2, 4);
  crowd.beginStep(); // without new offsets
  for (const i of [0, 1]) crowd.setPalette(i, capped.palette('walk', times[i]));
  isStep(3, 3, 4, 4);
  crowd.beginStep();
  crowd.setOffsets(1, wrinkles(5));
  isStep(3, 3, 4, 5);
  const still = capped.palette('walk', times[0]);
  crowd.setMotion(0, still, still);
  isStep(3, 3, 4, 5);
  crowd.setOffsets(0, wrinkles(6));
  isStep(3, 6, 4, 5);
  crowd.setMotion(0, still, still);
  crowd.setOffsets(0, wrinkles(7));
  isStep(6, 7, 4, 5);
  crowd.beginStep();
  crowd.setOffsets(1, null);
  const bare = [poseAt(0, 7), poseAt(0, 7), poseAt(1, 5), posed(times[1], null)];
  assert.deepEqual([...crowd.collideMoving().contacts], movingContacts(...bare)[0]);
  crowd.setOffsets(1, wrinkles(2));
  isStep(7, 7, 5, 2);
  for (const made of [crowd, ...bare]) made.delete();
});

/** A palette that moves the creature far away from all others. */
function placedAside(i) {
  return plain.palette(null, 0, [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 100 + 10 * i, 0, 0, 1]);
}

test('a crowd counts clamped offsets', () => {
  const crowd = pelt.makeCrowd();
  for (let i = 0; i < 2; ++i) crowd.add(capped);
  assert.equal(crowd.collide().stats.clampedOffsets, 0);
  crowd.setOffsets(0, wrinkles(1, 1));
  assert.ok(crowd.collide().stats.clampedOffsets > 100);
  crowd.delete();
});

test('wrong offsets are refused and change nothing', () => {
  const pose = posed(0.3, wrinkles(1));
  const before = pose.posedVertices();
  const crowd = pelt.makeCrowd();
  for (const character of [capped, plain]) crowd.add(character);
  const count = 3 * capped.vertexCount;
  for (const set of [(offsets) => pose.setOffsets(offsets), (offsets) => crowd.setOffsets(0, offsets)]) {
    refused(() => set(new Float32Array(3)), `offsets: expected ${count} numbers, found 3`);
    refused(() => set(undefined), `offsets: expected an array of ${count} numbers, found nothing`);
  }
  assert.deepEqual(pose.posedVertices(), before);
  const other = plain.makePose();
  const without = 'the model has no caps for offsets: set offsetCaps';
  refused(() => other.setOffsets(wrinkles(1)), without);
  refused(() => crowd.setOffsets(1, wrinkles(1)), without);
  refused(() => crowd.setOffsets(2, null), 'instance: the crowd has no instance 2');
  other.setOffsets(null);
  crowd.setOffsets(1, null);
  assert.deepEqual(other.posedVertices(), plain.makePose().posedVertices());
  for (const made of [pose, crowd, other]) made.delete();
});

test('wrong caps are refused', () => {
  const made = (offsetCaps) => () => pelt.generateCreature({ ...kCreature, name: 'walker', offsetCaps });
  refused(made(-1), 'offsetCaps: expected a number from 0 to 1152921504606847000, found -1');
  refused(made(NaN), /^offsetCaps: expected a number from 0/);
  refused(made(2 ** 61), /^offsetCaps: expected a number from 0/);
  refused(made([0, 1]), 'offsetCaps: expected a Float32Array, found an Array');
  refused(made(new Float32Array(3)), /: offsetCaps has 3 elements for \d+ restPositions$/);
  const wrong = (x) => new Float32Array(plain.vertexCount).fill(x, 7, 8);
  refused(made(wrong(NaN)), /: offsetCaps\[7\] is .*nan, expected 0 to 2\^60$/);
  refused(made(wrong(-1)), /: offsetCaps\[7\] is -1, expected 0 to 2\^60$/);
  refused(() => pelt.readScene('s.json', {}, { offsetCaps: 1 }), /^unknown option "offsetCaps"/);
  const { restPositions, triangles } = plain;
  refused(
    () => pelt.makeCharacter({ restPositions, triangles, offsetCaps: '1' }),
    'mesh.offsetCaps: expected a Float32Array, found a string',
  );
  const none = made(undefined)();
  assert.throws(() => none.makePose().setOffsets(wrinkles(1)), { message: /no caps/ });
});
