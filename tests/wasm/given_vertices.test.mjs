/** Poses with given vertices answer as if joints had posed the vertices there. */

import assert from 'node:assert/strict';
import test from 'node:test';
import { contactsOf, kFaces, pelt, readSceneFile, refused } from './support.mjs';

const creature = pelt.generateCreature({ triangles: 4000, joints: 30 });
const { restPositions, triangles } = creature;
const statue = pelt.makeCharacter({ name: 'statue', restPositions, triangles });

function posed(seconds, character = creature, part = null) {
  const pose = character.makePose(part);
  pose.setPalette(character.palette(character.clips[0].name, seconds));
  return pose;
}

function given(vertices, character, part = null) {
  const pose = character.makePose(part);
  pose.setVertices(vertices);
  return pose;
}

/** Two steps: skinned, with the vertices of the skinned poses, and of a mesh without joints. */
const kTimes = [0.1, 0.5, 0.2, 0.6];
const skinned = kTimes.map((seconds) => posed(seconds));
const copied = skinned.map((pose) => given(pose.posedVertices(), creature));
const jointless = skinned.map((pose) => given(pose.posedVertices(), statue));
const all = { 'the same character': copied, 'a mesh without joints': jointless };

/** Without counts of work, which differ. */
const withoutStats = (answer) => JSON.parse(JSON.stringify(answer, (key, value) => (key === 'stats' ? undefined : value)));

/** The answers of all queries of two poses that do not depend on the tree. */
function answersOf(a, b) {
  const { pairs, count } = pelt.collide(a, b);
  assert.ok(count > 500, `${count} contacts`);
  const { kinds, segments, normals: directions, depths, curves, patches } = pelt.describeContacts(a, b, pairs);
  const search = pelt.makeSearch(a, b, { order: 'contacts' });
  while (!search.isComplete) search.run(100_000);
  const found = search.pairs();
  search.delete();
  const ball = { kind: 'sphere', centre: [0, 1, 0], radius: 0.3 };
  return {
    pairs,
    found,
    deepest: pelt.deepestVertex(a, b),
    geometry: { kinds, segments, directions, depths, curves: curves.length, patches: patches.length },
    eager: pelt.collideEagerly(a, b).pairs,
    touch: pelt.intersects(a, b),
    distance: pelt.distance(a, b).distance,
    near: pelt.clearance(a, b, 0.01).pairs,
    isWithin: pelt.isWithin(a, b, 0),
    containment: pelt.containment(a, b),
    closest: a.closestPoint([0, 0.3, 3]).distance,
    sides: [a.sideOf([0, 0.3, 3]), a.sideOf([0, 1, 0])],
    hits: a.castAll([0, 0.9, 9], [0.01, 0, -1]),
    isHit: a.castAny([0, 0.9, 9], [0.01, 0, -1]),
    hit: a.cast([0, 0.9, 9], [0.01, 0, -1]),
    kind: a.classify(ball),
    touches: a.intersectsRegion(ball),
    region: a.findTriangles(ball),
    box: a.exactBounds().box,
    isClosed: a.isClosed,
    vertices: a.posedVertices(),
    normals: a.normals(),
  };
}

test('every query of two poses answers as for skinned poses', () => {
  const expected = withoutStats(answersOf(skinned[0], skinned[2]));
  assert.ok(expected.hits.length > 0 && expected.deepest !== null && expected.touches);
  assert.deepEqual(expected.sides, ['outside', 'inside']);
  for (const [name, [a, , b]] of Object.entries(all)) {
    assert.deepEqual(withoutStats(answersOf(a, b)), expected, name);
    assert.deepEqual(pelt.collide(skinned[0], b).pairs, pelt.collide(a, skinned[2]).pairs, 'both kinds');
  }
});

test('so do queries of one pose and queries of steps', () => {
  const motionsOf = ([from, to, other, end]) => [{ from, to }, { from: other, to: end }];
  const answersOfSteps = (poses) => {
    const [a, b] = motionsOf(poses);
    const filter = a.from.character.makeSelfFilter({ rings: 2 });
    const answers = {
      moving: pelt.collideMoving(a, b),
      first: pelt.firstContact(a, b),
      touch: pelt.touchWhileMoving(a, b),
      self: pelt.selfCollide(a.from, filter).pairs,
      selfMoving: pelt.selfCollideMoving(a, filter),
      selfTouch: pelt.selfTouchesWhileMoving(a, filter),
      intersects: pelt.selfIntersects(a.from, filter),
    };
    filter.delete();
    return withoutStats(answers);
  };
  const expected = answersOfSteps(skinned);
  assert.ok(expected.moving.count > 500 && expected.selfMoving.count > 0);
  for (const [name, poses] of Object.entries(all)) assert.deepEqual(answersOfSteps(poses), expected, name);
});

test('no vertices are skinned, and boxes are exact', () => {
  const [pose] = jointless;
  const box = pose.exactBounds().box;
  assert.deepEqual(pose.bounds().box, box);
  const { boxes } = pose.nodeBoxes(0);
  assert.deepEqual([...boxes], [...box.low, ...box.high]);
  const fresh = jointless.slice(0, 2).map((other) => given(other.posedVertices(), statue));
  assert.equal(pelt.collide(...fresh).stats.posedVertices, 0);
  assert.equal(pelt.collideEagerly(...fresh).stats.posedVertices, 0);
  for (const other of fresh) other.delete();
});

test('what is posed by joints again is as before', () => {
  const pose = creature.makePose();
  const vertices = skinned[0].posedVertices();
  for (const seconds of [0.3, 0.5]) {
    pose.setVertices(vertices);
    assert.deepEqual(pose.posedVertices(), vertices);
    pose.setPalette(creature.palette('walk', seconds));
    const other = posed(seconds);
    assert.deepEqual(pose.posedVertices(), other.posedVertices());
    assert.deepEqual(pelt.collideEagerly(pose, skinned[0]).pairs, pelt.collide(other, skinned[0]).pairs);
    other.delete();
  }
  const scene = readSceneFile(kFaces);
  const face = scene.characters[scene.instances[0].character].makePose();
  scene.setPose(face, 0, 5);
  const atFive = face.posedVertices();
  face.setVertices(face.character.restPositions);
  assert.notDeepEqual(face.posedVertices(), atFive);
  scene.setPose(face, 0, 5);
  assert.deepEqual(face.posedVertices(), atFive);
  face.setVertices(face.character.restPositions);
  face.setMorphWeights(scene.morphWeights(0, 5));
  assert.deepEqual(face.posedVertices(), atFive);
  for (const made of [pose, face, scene]) made.delete();
});

test('crowds take vertices, also in steps', () => {
  const [from, to, other, end] = skinned;
  const moving = pelt.collideMoving({ from, to }, { from: other, to: end });
  for (const character of [creature, statue]) {
    const crowd = pelt.makeCrowd();
    const set = (poses) => poses.forEach((pose, i) => crowd.setVertices(i, pose.posedVertices()));
    for (let i = 0; i < 2; ++i) crowd.add(character);
    set([from, other]);
    assert.deepEqual([...crowd.collide().contacts], contactsOf(pelt.collide(from, other).pairs));
    crowd.beginStep();
    set([to, end]);
    const found = crowd.collideMoving();
    assert.deepEqual([...found.contacts], contactsOf(moving.pairs));
    assert.deepEqual(found.times, moving.times);
    assert.deepEqual([...crowd.collide().contacts], contactsOf(pelt.collide(to, end).pairs));
    crowd.delete();
  }
});

test('a pose of a part takes the vertices of the character', () => {
  const face = pelt.generateFace({ triangles: 2000 });
  const [head, copy] = [posed(0.4, face, 0), given(posed(0.4, face).posedVertices(), face, 0)];
  const other = posed(0.1, face);
  const { count, pairs } = pelt.collide(head, other);
  assert.ok(count > 100, `${count} contacts`);
  assert.deepEqual(pelt.collide(copy, other).pairs, pairs);
  for (const made of [head, copy, other, face]) made.delete();
});

test('wrong vertices are refused and change nothing', () => {
  const pose = posed(0.3);
  const before = pose.posedVertices();
  const crowd = pelt.makeCrowd();
  crowd.add(creature);
  const count = restPositions.length;
  const set = (vertices, message) => {
    refused(() => pose.setVertices(vertices), message);
    refused(() => crowd.setVertices(0, vertices), message);
    assert.deepEqual(pose.posedVertices(), before);
  };
  set(restPositions.subarray(3), `vertices: expected ${count} numbers, found ${count - 3}`);
  set(null, `vertices: expected an array of ${count} numbers, found null`);
  const wrong = (x) => restPositions.map((y, i) => (i === 3 * 7 + 1 ? x : y));
  set(wrong(NaN), /^vertices\[7\] is \(.*nan.*\), expected finite coordinates within 2\^60$/);
  set(wrong(Infinity), /^vertices\[7\] is /);
  set(wrong(2 ** 61), /^vertices\[7\] is /);
  pose.setVertices(wrong(-(2 ** 60)));
  refused(() => crowd.setVertices(1, restPositions), 'instance: the crowd has no instance 1');
  for (const made of [pose, crowd]) made.delete();
});

test('vertices that are merged cannot be moved apart', () => {
  const arrays = { restPositions: Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0) };
  arrays.triangles = Uint16Array.of(0, 1, 2, 3, 5, 4);
  const apart = arrays.restPositions.map((x, i) => (i === 3 * 3 + 2 ? 1 : x));
  const free = pelt.makeCharacter(arrays).makePose();
  free.setVertices(apart);
  assert.deepEqual(free.posedVertices(), apart);
  const merged = pelt.makeCharacter({ ...arrays, weld: true }).makePose();
  refused(
    () => merged.setVertices(apart),
    /^vertices\[3\] differs from vertices\[1\], .*: build it with weld: false$/,
  );
  merged.setVertices(arrays.restPositions.map((x) => 2 * x));
  for (const pose of [free, merged]) pose.delete();
});
