/** Queries of poses. */

import assert from 'node:assert/strict';
import test from 'node:test';
import { NodeState, pelt } from './support.mjs';

const character = pelt.generateCreature({ triangles: 4000, joints: 40 });
const kTurned = [-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, 0.2, 1];

/** Two walkers, the second one turned and `far` away. */
function twoPoses(far = 0.2) {
  const placement = [...kTurned];
  placement[14] = far;
  const [a, b] = [character.makePose(), character.makePose()];
  a.setPalette(character.palette('walk', 0.3));
  b.setPalette(character.palette('walk', 0.8, placement));
  return [a, b];
}

function cornersOf(positions, triangle) {
  return [0, 1, 2].map((c) => {
    const v = character.triangles[3 * triangle + c];
    return positions.subarray(3 * v, 3 * v + 3);
  });
}

function boxOf(positions) {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  positions.forEach((x, i) => {
    low[i % 3] = Math.min(low[i % 3], x);
    high[i % 3] = Math.max(high[i % 3], x);
  });
  return { low, high };
}

test('bad palettes are refused and leave the pose as it was', () => {
  const [a] = twoPoses();
  const before = a.posedVertices();
  const bad = character.palette('walk', 0.3);
  bad[16 * 7 + 3] = NaN;
  assert.throws(() => a.setPalette(bad), { code: 'invalid_argument', message: /palette\[7\] has the element nan/ });
  assert.throws(() => a.setPalette(bad.subarray(1)), /palette: expected 640 numbers, found 639/);
  assert.throws(() => a.posedVertices(new Float32Array(3)), /out: expected a Float32Array of/);
  assert.deepEqual(a.posedVertices(), before);
  assert.throws(() => character.palette('fly', 0), /has no clip "fly", expected one of "walk", "idle"$/);
  assert.throws(() => character.palette('wlak', 0), /has no clip "wlak", did you mean "walk"\?$/);
});

test('doubles of a palette are rounded once, to the nearest float', () => {
  const [a, b] = twoPoses();
  const doubles = Float64Array.from(character.palette('walk', 0.3), (x) => x * (1 + 2 ** -26));
  a.setPalette(doubles);
  b.setPalette(Float32Array.from(doubles, Math.fround));
  assert.notDeepEqual(Float64Array.from(doubles, Math.fround), doubles, 'a palette worth testing');
  assert.deepEqual(a.posedVertices(), b.posedVertices());
});

test('exact bounds are those of the vertices, and others enclose them', () => {
  const [a] = twoPoses();
  const exact = boxOf(a.posedVertices());
  assert.deepEqual(a.exactBounds().box, exact);
  for (const levels of [0, 1, 3]) {
    const { box, centre, radius } = a.bounds(levels);
    for (const axis of [0, 1, 2]) {
      assert.ok(box.low[axis] <= exact.low[axis] && exact.high[axis] <= box.high[axis]);
      assert.ok(centre[axis] - radius <= exact.low[axis]);
    }
  }
});

const minus = (a, b) => a.map((x, axis) => x - b[axis]);
const cross = ([a, b, c], [x, y, z]) => [b * z - c * y, c * x - a * z, a * y - b * x];

test('normals are those of the triangles around a vertex, by area', () => {
  const [a] = twoPoses();
  const [positions, normals] = [a.posedVertices(), a.normals()];
  const sums = new Float64Array(positions.length);
  for (let t = 0; t < character.triangleCount; ++t) {
    const [p, q, r] = cornersOf(positions, t).map((corner) => Array.from(corner));
    const area = cross(minus(q, p), minus(r, p));
    for (const v of character.triangles.subarray(3 * t, 3 * t + 3)) {
      area.forEach((x, axis) => (sums[3 * v + axis] += x));
    }
  }
  for (let i = 0; i < sums.length; i += 3) {
    const [n, sum] = [normals.subarray(i, i + 3), sums.subarray(i, i + 3)];
    const along = n.reduce((dot, x, axis) => dot + x * sum[axis], 0);
    assert.ok(Math.abs(Math.hypot(...n) - 1) < 1e-5);
    assert.ok(along > 0.999 * Math.hypot(...sum));
  }
});

test('boxes of each level enclose the surface; queries open some of them', () => {
  const [a, b] = twoPoses();
  const positions = a.posedVertices();
  assert.equal(a.openedNodeCount, 0);
  const untouched = a.nodeBoxes(character.levelCount - 1);
  assert.ok(untouched.states.every((state) => state === NodeState.untouched));
  assert.equal(a.openedNodeCount, 0);
  assert.ok(pelt.collide(a, b).count > 0);
  const { openedNodeCount } = a;
  assert.ok(openedNodeCount > 0 && openedNodeCount < character.nodeCount);
  for (let level = 0; level < character.levelCount; ++level) {
    const { count, boxes, states } = a.nodeBoxes(level);
    assert.equal(boxes.length, 6 * count);
    assert.equal(states.length, count);
    if (level > 0) assert.ok(states.includes(NodeState.opened) || level > 1);
    for (let v = 0; v < character.vertexCount; v += 17) {
      assert.ok(someBoxHas(boxes, positions.subarray(3 * v, 3 * v + 3)), `level ${level}`);
    }
  }
  const deep = a.nodeBoxes(character.levelCount - 1).states;
  for (const state of Object.values(NodeState)) assert.ok(deep.includes(state), `state ${state}`);
  assert.equal(a.openedNodeCount, openedNodeCount);
});

function someBoxHas(boxes, [x, y, z]) {
  for (let i = 0; i < boxes.length; i += 6) {
    const [x0, y0, z0, x1, y1, z1] = boxes.subarray(i, i + 6);
    if (x0 <= x && x <= x1 && y0 <= y && y <= y1 && z0 <= z && z <= z1) return true;
  }
  return false;
}

test('a ray hits where its triangle is', () => {
  const [a] = twoPoses();
  const positions = a.posedVertices();
  const { centre } = a.exactBounds();
  const hit = a.cast([centre[0], 1.1, -5], [0, 0, 1]);
  const corners = cornersOf(positions, hit.triangle);
  for (const axis of [0, 1, 2]) {
    const point = hit.weights.reduce((sum, w, c) => sum + w * corners[c][axis], 0);
    assert.ok(Math.abs(point - [centre[0], 1.1, -5 + hit.t][axis]) < 1e-5);
  }
  assert.ok(hit.normal[2] < 0);
  assert.equal(a.cast([centre[0], 1.1, -5], [0, 0, 1], { maxT: 0.5 * hit.t }), null);
  assert.equal(a.cast([50, 1.1, -5], [0, 0, 1]), null);
});

test('the distance is that of two points of the surfaces', () => {
  const [a, b] = twoPoses(3);
  assert.equal(pelt.collide(a, b).count, 0);
  const closest = pelt.distance(a, b);
  const gap = closest.a.position.map((x, axis) => x - closest.b.position[axis]);
  assert.ok(Math.abs(Math.hypot(...gap) - closest.distance) < 1e-5);
  assert.ok(closest.distance > 1 && closest.distance < 3);
  assert.equal(pelt.distance(a, b, { maxDistance: 0.5 }), null);
  const [c, d] = twoPoses();
  assert.equal(pelt.distance(c, d).distance, 0);
});

test('contacts are described one by one, as curves and as patches', () => {
  const [a, b] = twoPoses();
  const { count, pairs } = pelt.collide(a, b);
  const described = pelt.describeContacts(a, b, pairs);
  assert.equal(described.segments.length, 6 * count);
  for (const array of [described.kinds, described.depths]) assert.equal(array.length, count);
  for (let i = 0; i < count; ++i) {
    assert.equal(described.joints[2 * i], character.triangleJoints[pairs[2 * i]]);
    assert.equal(described.joints[2 * i + 1], character.triangleJoints[pairs[2 * i + 1]]);
  }
  assert.ok(described.curves.length > 0);
  for (const { isClosed, points } of described.curves) {
    if (isClosed) assert.deepEqual(points.slice(0, 3), points.slice(-3));
  }
  const segments = described.curves.reduce((sum, { points }) => sum + points.length / 3 - 1, 0);
  assert.equal(segments, described.kinds.filter((kind) => kind === 0).length);
  const members = described.patches.flatMap((patch) => Array.from(patch.contacts));
  assert.deepEqual(members.sort((x, y) => x - y), Array.from({ length: count }, (_, i) => i));
  const backwards = Uint32Array.from(pairs).reverse();
  assert.throws(() => pelt.describeContacts(a, b, backwards), /pairs:/);
});

test('a pose is not asked for its contacts with itself', () => {
  const [a] = twoPoses();
  assert.throws(() => pelt.collide(a, a), /two different poses/);
});
