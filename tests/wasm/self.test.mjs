/** Contacts of poses with themselves, and their filters. */

import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import test from 'node:test';
import { rocks } from './gltf.mjs';
import { ContactKind, jsonLines, kScenes, kShared, pelt, readSceneFile } from './support.mjs';

const kNothing = { takesPart: 0, rings: 0, atRest: 0, always: 0, joints: 0, groups: 0 };

const creature = pelt.generateCreature({ triangles: 6000, joints: 30 });
const pose = creature.makePose();

/** Turns all joints of a palette about the axis z, each by its own angle, so that limbs overlap. */
function twist(character, angle) {
  const palette = character.palette('walk', 0.3);
  for (let j = 0; j < character.jointCount; ++j) {
    const turned = ((j % 5) - 2) * angle;
    const [c, s] = [Math.cos(turned), Math.sin(turned)];
    for (let column = 0; column < 4; ++column) {
      const at = 16 * j + 4 * column;
      const [x, y] = palette.subarray(at, at + 2);
      palette.set([c * x - s * y, s * x + c * y], at);
    }
  }
  return palette;
}

/** Contacts of the twisted pose with these options. */
function contactsWith(options) {
  const filter = creature.makeSelfFilter(options);
  const found = pelt.selfCollide(pose, filter);
  assert.equal(pelt.selfIntersects(pose, filter), found.count > 0);
  filter.delete();
  return found;
}

pose.setPalette(twist(creature, 0.35));
const all = contactsWith(undefined);

const rowsOf = (numbers, width) =>
  Array.from({ length: numbers.length / width }, (_, i) =>
    Array.from(numbers.subarray(width * i, width * (i + 1))),
  );
const pairs = rowsOf(all.pairs, 2);

/** Checks which pairs an option leaves out, and that it says so. */
function leavesOut(name, options, isLeftOut) {
  const kept = pairs.filter((pair) => !isLeftOut(pair));
  const { count, pairs: found, leftOut } = contactsWith(options);
  assert.deepEqual(rowsOf(found, 2), kept);
  assert.deepEqual(leftOut, { ...kNothing, [name]: pairs.length - kept.length });
  assert.ok(count < pairs.length, 'nothing is left out');
}

test('contacts ascend, and the lower triangle is first', () => {
  assert.ok(all.count > 200, `${all.count} contacts`);
  assert.deepEqual(all.leftOut, kNothing);
  assert.equal(all.stats.posedVertices > creature.vertexCount / 2, true);
  let last = [-1, -1];
  for (const [s, t] of pairs) {
    assert.ok(s < t && (s > last[0] || (s === last[0] && t > last[1])));
    last = [s, t];
  }
});

test('limits cut the contacts short', () => {
  const filter = creature.makeSelfFilter();
  const some = pelt.selfCollide(pose, filter, { maxContacts: 5 });
  assert.equal(some.count, 5);
  assert.ok(some.stats.cutShort);
  assert.equal(pelt.selfCollide(pose, filter, { firstContact: true }).count, 1);
  filter.delete();
});

test('each filter leaves out what it is for, and counts it', () => {
  const corners = rowsOf(creature.triangles, 3);
  const { restPositions, triangleJoints, triangleCount } = creature;
  const places = corners.map((triangle) =>
    triangle.map((v) => restPositions.subarray(3 * v, 3 * v + 3).join()),
  );
  const areNeighbours = ([s, t]) => places[s].some((place) => places[t].includes(place));
  if (pairs.some(areNeighbours)) leavesOut('rings', { rings: 1 }, areNeighbours);
  const half = all.pairs.slice(0, 2 * Math.floor(all.count / 2));
  const isInHalf = (pair) => pairs.findIndex((p) => `${p}` === `${pair}`) < half.length / 2;
  leavesOut('atRest', { atRest: half }, isInHalf);
  leavesOut('always', { always: half.slice().reverse() }, isInHalf);
  const [hidden] = pairs[0];
  const takesPart = new Uint8Array(triangleCount).fill(1);
  takesPart[hidden] = 0;
  leavesOut('takesPart', { takesPart }, (pair) => pair.includes(hidden));
  const jointPairs = Uint16Array.from(pairs[0], (t) => triangleJoints[t]);
  const key = (numbers) => Array.from(numbers).sort((x, y) => x - y).join();
  const jointsOf = (pair) => key(pair.map((t) => triangleJoints[t]));
  leavesOut('joints', { jointPairs }, (pair) => jointsOf(pair) === key(jointPairs));
  const groups = Uint16Array.from({ length: triangleCount }, (_, t) => t % 7);
  const groupPairs = Uint16Array.of(3, 1, 5, 5);
  const groupsOf = (pair) => key(pair.map((t) => t % 7));
  leavesOut('groups', { groups, groupPairs }, (pair) => ['1,3', '5,5'].includes(groupsOf(pair)));
});

test('a tally finds the pairs of most poses', () => {
  const tally = pelt.makeContactTally();
  const filter = creature.makeSelfFilter();
  const counts = new Map();
  for (let i = 0; i < 6; ++i) {
    pose.setPalette(twist(creature, 0.3 + 0.01 * i));
    const found = pelt.selfCollide(pose, filter).pairs;
    tally.add(found);
    for (const pair of rowsOf(found, 2)) counts.set(`${pair}`, (counts.get(`${pair}`) ?? 0) + 1);
  }
  pose.setPalette(twist(creature, 0.35));
  assert.equal(tally.poseCount, 6);
  const sizes = [0, 0.5, 1].map((share) => {
    const expected = [...counts].filter(([, count]) => count >= 6 * share).map(([pair]) => pair);
    const pairs = rowsOf(tally.inShareOfPoses(share), 2).map((pair) => `${pair}`);
    assert.deepEqual(pairs.slice().sort(), expected.sort());
    return pairs.length;
  });
  assert.ok(sizes[0] > sizes[1] && sizes[1] > sizes[2] && sizes[2] > 0, `${sizes}`);
  assert.throws(() => tally.add(Uint32Array.of(1, 2, 1, 2)), /^PeltError: pairs: pair 1 is not greater/);
  assert.throws(() => tally.add(Uint32Array.of(1, 2, 3)), /^PeltError: pairs: expected a multiple of 2/);
  assert.throws(() => tally.inShareOfPoses(1.5), /^PeltError: share: expected a number from 0 to 1/);
  tally.delete();
  filter.delete();
});

test('near joints are neighbours, and those whose triangles touch at rest', () => {
  const { leftOut, count } = contactsWith({ nearJoints: true });
  assert.equal(count + leftOut.joints, all.count);
  const { triangleJoints } = creature;
  const same = pairs.filter(([s, t]) => triangleJoints[s] === triangleJoints[t]).length;
  assert.ok(leftOut.joints > same && count > 0, `${same} of ${leftOut.joints}, ${count} left`);
  const { pairs: [s, t] } = contactsWith({ nearJoints: true });
  const atRest = Uint32Array.of(s, t);
  const joined = contactsWith({ nearJoints: true, atRest });
  const key = (pair) => pair.map((triangle) => triangleJoints[triangle]).sort().join();
  assert.equal(joined.leftOut.atRest + joined.leftOut.joints + joined.count, all.count);
  assert.ok(rowsOf(joined.pairs, 2).every((pair) => key(pair) !== key([s, t])));
});

const kHuman = path.join(kShared, 'models', 'human.glb');

test(
  'near joints drop what the command drops: creases, and nothing far from a joint',
  { skip: !fs.existsSync(kHuman) && `${kHuman} is not there` },
  () => {
    const human = pelt.readCharacter(fs.readFileSync(kHuman), { name: 'human' });
    const filter = human.makeSelfFilter({ rings: 5, nearJoints: true });
    const body = human.makePose();
    const options = ['--clip', 'crouch_walk', '--frames', '54:60', '--self-at-rest', 'keep'];
    const frames = jsonLines('check', kHuman, ...options).filter(({ frame }) => frame !== undefined);
    assert.equal(frames.length, 6);
    const nameOf = (t) => human.jointNames[human.triangleJoints[t]];
    let far = 0;
    for (const { time, contacts, left_out: leftOut } of frames) {
      body.setPalette(human.palette('crouch_walk', time));
      const found = pelt.selfCollide(body, filter);
      assert.equal(found.count, contacts);
      assert.equal(found.leftOut.joints, leftOut.near_joints);
      assert.ok(leftOut.near_joints > 0);
      for (const pair of rowsOf(found.pairs, 2)) {
        const names = pair.map(nameOf).sort().join();
        far += names === 'lowerleg01.R,upperleg02.R' || names === 'lowerleg01.L,upperleg02.L';
      }
    }
    assert.ok(far > 20, `${far} contacts of calf and thigh`);
    filter.delete();
    body.delete();
    human.delete();
  },
);

test('geometry of contacts with itself has curves and patches', () => {
  const geometry = pelt.describeSelfContacts(pose, all.pairs);
  assert.equal(geometry.kinds.length, all.count);
  assert.ok(geometry.kinds.includes(ContactKind.segment));
  assert.ok(geometry.curves.length > 0);
  const members = geometry.patches.reduce((sum, { contacts }) => sum + contacts.length, 0);
  assert.equal(members, all.count);
  const swapped = Uint32Array.of(pairs[0][1], pairs[0][0]);
  assert.throws(() => pelt.describeSelfContacts(pose, swapped), /lower triangle first/);
  assert.throws(() => pelt.describeContacts(pose, pose, all.pairs), /two different poses/);
});

test('a part has its own filter, with the triangle numbers of the character', () => {
  const cairn = pelt.readCharacter(rocks(['base', 'top']), { name: 'cairn' });
  const [{ triangleCount: first }, { triangleCount: count }] = cairn.parts;
  const top = cairn.makePose(1);
  const filter = cairn.makeSelfFilter({ takesPart: new Uint8Array(count).fill(1) }, 1);
  assert.equal(filter.part, 1);
  assert.equal(pelt.selfIntersects(top, filter), false);
  top.setPalette(flatPalette(cairn));
  const found = pelt.selfCollide(top, filter);
  assert.ok(found.count > 0);
  assert.ok(found.pairs.every((triangle) => triangle >= first && triangle < first + count));
  const without = cairn.makeSelfFilter({ atRest: found.pairs }, 1);
  assert.equal(pelt.selfCollide(top, without).leftOut.atRest, found.count);
  const whole = cairn.makeSelfFilter();
  assert.throws(() => pelt.selfCollide(top, whole), /another character or part/);
  const ofOther = cairn.makeSelfFilter({ atRest: Uint32Array.of(0, 1) }, 1);
  assert.equal(pelt.selfCollide(top, ofOther).count, found.count, 'pairs of other parts do not matter');
  assert.throws(() => cairn.makeSelfFilter({ atRest: Uint32Array.of(cairn.triangleCount, 1) }, 1),
                /^PeltError: atRest\[0\]: expected a whole number from 0 to/);
  cairn.delete();
});

test('with filters of parts, a limit ends the tests of parts against themselves early', () => {
  const cairn = pelt.readCharacter(rocks(['base', 'top']), { name: 'cairn' });
  const crowd = crowdOfStones(cairn, [0, 1]);
  const filters = [0, 1].map((part) => cairn.makeSelfFilter({}, part));
  filters.forEach((filter, part) => crowd.setSelfFilter(part, filter));
  crowd.filterParts([0, 1], cairn.makeSelfFilter());
  const all = rowsOf(crowd.collide().contacts, 4);
  const { contacts, stats } = crowd.collide({ maxContacts: 2 });
  const rows = rowsOf(contacts, 4);
  assert.deepEqual(rows.map(([a, b]) => `${a}${b}`), ['00', '00', '01', '01', '11', '11']);
  for (const row of rows) assert.ok(all.some((other) => String(other) === String(row)));
  assert.equal(stats.cutShort, true);
  const pose = cairn.makePose(0);
  pose.setPalette(flatPalette(cairn));
  const own = pelt.selfCollide(pose, filters[0], { maxContacts: 2 });
  assert.deepEqual(rows.slice(0, 2).map((row) => row.slice(2)), rowsOf(own.pairs, 2));
  crowd.delete();
  cairn.delete();
});

test('the first contacts of pairs do not depend on tests of instances against themselves', () => {
  const filter = creature.makeSelfFilter({ rings: 5 });
  const [alone, tested] = [pelt.makeCrowd(), pelt.makeCrowd()];
  for (const crowd of [alone, tested]) {
    for (const _ of [0, 1]) crowd.add(creature);
  }
  for (const instance of [0, 1]) tested.setSelfFilter(instance, filter);
  let found = 0;
  for (let step = 0; step < 20; ++step) {
    for (const crowd of [alone, tested]) {
      crowd.setPalette(0, creature.palette('walk', 0.05 * step));
      crowd.setPalette(1, twist(creature, 0.1 + 0.02 * step));
    }
    const first = rowsOf(alone.collide({ maxContacts: 3 }).contacts, 4);
    const ofPairs = rowsOf(tested.collide({ maxContacts: 3 }).contacts, 4).filter(([a, b]) => a < b);
    assert.deepEqual(ofPairs, first);
    found += first.length;
  }
  assert.equal(found, 60);
  for (const object of [alone, tested, filter]) object.delete();
});

/** All triangles collapse to one point. */
function flatPalette(cairn) {
  const flat = new Float32Array(16 * cairn.jointCount);
  for (let j = 0; j < cairn.jointCount; ++j) flat[16 * j + 15] = 1;
  return flat;
}

/** A crowd of both stones of a cairn, which have collapsed to one point. */
function crowdOfStones(cairn, parts) {
  const crowd = pelt.makeCrowd();
  for (const part of parts) crowd.setPalette(crowd.add(cairn, part), flatPalette(cairn));
  return crowd;
}

test('contacts of two parts pass the filter of their character', () => {
  const cairn = pelt.readCharacter(rocks(['base', 'top']), { name: 'cairn' });
  for (const parts of [[0, 1], [1, 0]]) {
    const crowd = crowdOfStones(cairn, parts);
    const all = rowsOf(crowd.collide().contacts, 4);
    assert.ok(all.length > 1);
    const [, ...others] = all;
    const [first] = all;
    const atRest = Uint32Array.from(first.slice(2).sort((a, b) => a - b));
    crowd.filterParts([0, 1], cairn.makeSelfFilter({ atRest }));
    const found = crowd.collide();
    assert.deepEqual(rowsOf(found.contacts, 4), others);
    assert.deepEqual(found.leftOut, { ...kNothing, atRest: 1 });
    const limited = crowd.collide({ firstContact: true });
    assert.deepEqual(rowsOf(limited.contacts, 4), others.slice(0, 1));
    assert.equal(limited.stats.cutShort, true);
    crowd.delete();
  }
  const crowd = crowdOfStones(cairn, [0, 1, null]);
  const whole = cairn.makeSelfFilter();
  assert.throws(() => crowd.filterParts([0, 2], whole), /instances\[1\]: expected a part/);
  assert.throws(() => crowd.filterParts([0], cairn.makeSelfFilter({}, 0)), /another character or part/);
  assert.throws(() => crowd.filterParts([0], creature.makeSelfFilter()), /another character or part/);
  assert.throws(() => crowd.filterParts(0, whole), /instances: expected an array/);
  crowd.filterParts([0, 1], whole);
  whole.delete();
  assert.equal(rowsOf(crowd.collide().contacts, 4).filter(([a, b]) => a === 0 && b === 1).length > 1, true);
  crowd.delete();
  cairn.delete();
});

test('wrong filters are refused in words', () => {
  const refused = (options, message) =>
    assert.throws(() => creature.makeSelfFilter(options), { name: 'PeltError', message });
  refused({ ring: 1 }, /^unknown option "ring", did you mean "rings"\?/);
  refused({ rings: 65 }, 'rings: expected a whole number from 0 to 64, found 65');
  refused({ takesPart: new Uint8Array(3) }, `takesPart: expected ${creature.triangleCount} numbers, found 3`);
  refused({ takesPart: [1] }, 'takesPart: expected a Uint8Array, found an Array');
  refused({ atRest: new Uint32Array(3) }, 'atRest: expected a multiple of 2 numbers, found 3');
  refused({ always: Uint32Array.of(0, creature.triangleCount) }, /^always\[1\]: expected a whole number/);
  refused({ jointPairs: Uint16Array.of(30, 0) }, /^jointPairs\[0\]: expected a whole number from 0 to 29/);
  refused({ groupPairs: Uint16Array.of(1, 2) }, 'groupPairs: needs the option groups');
  const filter = creature.makeSelfFilter();
  filter.delete();
  assert.throws(() => pelt.selfCollide(pose, filter), /self filter of .* has been deleted/);
  assert.throws(() => pelt.selfCollide(creature, filter), /^PeltError: pose: expected a Pose/);
});

/** The native answer is in tests/crowd/crowd_hash_test.cpp. */
test('a crowd with self filters has the hash of native code', () => {
  const scene = readSceneFile(path.join(kScenes, 'passing_through.json'));
  const filters = scene.characters.map((character) => character.makeSelfFilter());
  const crowd = pelt.makeCrowd();
  const hash = pelt.makeContactHash();
  for (const { character } of scene.instances) {
    crowd.setSelfFilter(crowd.add(scene.characters[character]), filters[character]);
  }
  for (const filter of filters) filter.delete();
  const totals = { contacts: 0, selves: 0 };
  for (let frame = 0; frame < 30; ++frame) {
    scene.instances.forEach((_, i) => crowd.setPalette(i, scene.palette(i, frame)));
    const { contacts, count, leftOut } = crowd.collide();
    hash.addCrowd(frame, contacts);
    totals.contacts += count;
    totals.selves += rowsOf(contacts, 4).filter(([a, b]) => a === b).length;
    assert.deepEqual(leftOut, kNothing);
  }
  assert.equal(totals.contacts, 769);
  assert.ok(totals.selves > 100);
  assert.equal(hash.value, 'b69179c7a678acb4');
  crowd.setSelfFilter(0, null);
  crowd.setSelfFilter(1, null);
  assert.ok(rowsOf(crowd.collide().contacts, 4).every(([a, b]) => a < b));
  assert.throws(() => crowd.setSelfFilter(0, creature.makeSelfFilter()), /another character or part/);
  for (const made of [crowd, hash, scene]) made.delete();
});
