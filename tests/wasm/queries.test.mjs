/** Regions, rays, distances and inside: the answers of the command, for two faces. */

import assert from 'node:assert/strict';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import test from 'node:test';
import { jsonLines, pelt, refused } from './support.mjs';

const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'pelt-'));
test.after(() => fs.rmSync(folder, { recursive: true }));
const file = path.join(folder, 'faces.json');
const face = { model: 'face', clip: 'talk', translation: [0, 0, -0.55], velocity: [0, 0, 0.2] };
const other = {
  model: 'other',
  clip: 'talk',
  start: 0.4,
  translation: [0.05, 0, 0.55],
  rotation: [0, 1, 0, 0],
  velocity: [0, 0, -0.2],
};
const models = {
  face: { face: { triangles: 3000 } },
  other: { face: { triangles: 2400, seed: 2 } },
};
const frames = { count: 48, fps: 24 };
fs.writeFileSync(file, JSON.stringify({ models, frames, instances: [face, other] }));

/** Apart, and deep in each other. */
const kFrames = [4, 44];
const scene = pelt.readScene('faces.json', { 'faces.json': fs.readFileSync(file) });
const poses = scene.instances.map(({ character }) => scene.characters[character].makePose());
const [a, b] = poses;

function poseAt(frame) {
  poses.forEach((pose, i) => scene.setPose(pose, i, frame));
}

/** Calls `compare` with what the command writes of each of the frames, which then are posed here. */
function atEachFrame(compare, verb, ...args) {
  const [, ...lines] = jsonLines(verb, file, '--frames', '4:45:40', ...args);
  kFrames.forEach((frame, i) => {
    assert.equal(lines[i].frame, frame);
    poseAt(frame);
    compare(lines[i]);
  });
}

for (const [bounds, ...args] of [['bounds'], ['exactBounds', '--exact']]) {
  test(`${bounds} are those of the command`, () => {
    atEachFrame(
      (line) => {
        for (const { index, box, sphere } of line.bounds) {
          assert.deepEqual(poses[index][bounds](), { box, ...sphere });
        }
      },
      ...['bounds', ...args],
    );
  });
}

const kRegions = [
  [
    { kind: 'box', low: [-0.1, 0.2, -0.6], high: [0.15, 0.5, 0] },
    '--box',
    '-0.1,0.2,-0.6,0.15,0.5,0',
  ],
  [{ kind: 'sphere', centre: [0, 0.35, -0.2], radius: 0.2 }, '--sphere', '0,0.35,-0.2,0.2'],
  [
    { kind: 'capsule', a: [0, 0, 0], b: [0, 1, 0], radius: 0.125 },
    '--capsule',
    '0,0,0,0,1,0,0.125',
  ],
];

for (const [region, option, numbers] of kRegions) {
  test(`what is in a ${region.kind} is what the command finds there`, () => {
    let touching = 0;
    atEachFrame(
      ({ placements }) => {
        for (const native of placements) {
          const pose = poses[native.index];
          assert.equal(pose.classify(region), native.placement);
          assert.equal(pose.intersectsRegion(region), native.placement !== 'outside');
          const found = pose.findTriangles(region);
          assert.deepEqual(Array.from(found.intersecting), native.intersecting);
          assert.deepEqual(Array.from(found.inside), native.inside);
          touching += found.intersecting.length;
        }
      },
      ...['region', `${option}=${numbers}`, '--triangles'],
    );
    assert.ok(touching > 500, `${touching} triangles`);
  });
}

/** The same box of side 1/2 around 0 1/4 0. */
const kSameBoxes = {
  orientedBox: { centre: [0, 0.25, 0], half: [0.25, 0.25, 0.25] },
  turnedBox: {
    kind: 'orientedBox',
    centre: [0, 0.25, 0],
    axes: [
      [0, 1, 0],
      [0, 0, 1],
      [1, 0, 0],
    ],
    half: [0.25, 0.25, 0.25],
  },
  polyhedron: {
    faces: [
      { normal: [1, 0, 0], offset: 0.25 },
      { normal: [-1, 0, 0], offset: 0.25 },
      { normal: [0, 2, 0], offset: 1 },
      { normal: [0, -1, 0], offset: 0 },
      { normal: [0, 0, 1], offset: 0.25 },
      { normal: [0, 0, -4], offset: 1 },
    ],
  },
  frustum: { viewProjection: [4, 0, 0, 0, 0, 4, 0, 0, 0, 0, -4, 0, 0, -1, 0, 1] },
  webgpu: {
    kind: 'frustum',
    viewProjection: [4, 0, 0, 0, 0, 4, 0, 0, 0, 0, -2, 0, 0, -1, 0.5, 1],
    depth: 'zeroToOne',
  },
};

test('a box is the same box in whatever way it is given', () => {
  poseAt(44);
  const box = a.findTriangles({ kind: 'box', low: [-0.25, 0, -0.25], high: [0.25, 0.5, 0.25] });
  assert.ok(box.intersecting.length > box.inside.length && box.inside.length > 300);
  for (const [kind, region] of Object.entries(kSameBoxes)) {
    const { intersecting, inside } = a.findTriangles({ kind, ...region });
    assert.deepEqual(
      { intersecting, inside },
      { intersecting: box.intersecting, inside: box.inside },
      kind,
    );
  }
});

test('what lies behind a plane does so by its corners', () => {
  poseAt(4);
  const positions = a.posedVertices();
  const { triangles, triangleCount } = a.character;
  const isBehind = (v) => positions[3 * v + 1] <= 0.25;
  const corners = (t) => Array.from(triangles.subarray(3 * t, 3 * t + 3));
  const all = Array.from({ length: triangleCount }, (_, t) => t);
  const { intersecting, inside } = a.findTriangles({
    kind: 'halfSpace',
    normal: [0, 1, 0],
    offset: 0.25,
  });
  assert.deepEqual(
    Array.from(inside),
    all.filter((t) => corners(t).every(isBehind)),
  );
  assert.deepEqual(
    Array.from(intersecting),
    all.filter((t) => corners(t).some(isBehind)),
  );
  assert.ok(
    inside.length > 300 &&
      inside.length < intersecting.length &&
      intersecting.length < triangleCount,
  );
});

const kRays = [
  ['0,0.35,-3', '0.02,0.35,3'],
  ['-2,0.2,-0.15', '2,0.25,0.1'],
  ['0.05,3,-0.2', '0.06,0,0.1'],
];

for (const facing of ['both', 'front', 'back']) {
  test(`rays hit what the command says they hit, facing ${facing}`, () => {
    const words = kRays.flatMap(([from, to]) => [`--from=${from}`, `--to=${to}`]);
    let hits = 0;
    atEachFrame(
      ({ rays }) => {
        for (const { ray, hits: native } of rays) {
          const [from, to] = kRays[ray].map((text) => text.split(',').map(Math.fround));
          const direction = to.map((x, axis) => Math.fround(x - from[axis]));
          const options = { maxT: 1, facing };
          poses.forEach((pose, index) => {
            const expected = native.find((hit) => hit.index === index);
            const hit = pose.cast(from, direction, options);
            assert.equal(pose.castAny(from, direction, options), hit !== null);
            assert.equal(hit?.triangle, expected?.triangle);
            if (hit === null) return;
            const { t, normal, weights } = expected;
            assert.deepEqual(hit, { triangle: hit.triangle, t, weights, normal });
            ++hits;
          });
        }
      },
      ...['ray', ...words, '--facing', facing],
    );
    assert.ok(hits > 4, `${hits} hits`);
  });
}

test('all hits of a ray ascend, and each is the first one beyond the one before', () => {
  poseAt(44);
  const [origin, direction] = [
    [0, 0.3, -3],
    [0.003, 0.001, 1],
  ];
  const hits = a.castAll(origin, direction);
  assert.ok(hits.length >= 2 && hits.length % 2 === 0, `${hits.length} hits`);
  let minT = 0;
  for (const hit of hits) {
    assert.deepEqual(a.cast(origin, direction, { minT }), hit);
    minT = hit.t + 1e-6;
  }
  assert.equal(a.cast(origin, direction, { minT }), null);
  const sides = ['front', 'back'].flatMap((facing) => a.castAll(origin, direction, { facing }));
  assert.deepEqual(
    sides.sort((x, y) => x.t - y.t),
    hits,
  );
});

test('distances and their points are those of the command', () => {
  let apart = 0;
  atEachFrame(({ pairs: [native] }) => {
    const { distance, lowerBound, a: p, b: q } = pelt.distance(a, b);
    assert.equal(distance, native.distance);
    assert.equal(lowerBound, distance);
    assert.deepEqual([p.triangle, q.triangle], native.triangles);
    assert.deepEqual([p.position, q.position], native.points);
    assert.equal(pelt.isWithin(a, b, distance), true);
    if (distance === 0) return;
    ++apart;
    assert.equal(pelt.isWithin(a, b, 0.999 * distance), false);
    const rough = pelt.distance(a, b, { tolerance: 0.1 });
    assert.ok(rough.lowerBound <= distance && distance <= rough.distance);
    assert.ok(rough.distance - rough.lowerBound <= 0.1 + 1e-9);
  }, 'distance');
  assert.equal(apart, 1);
});

test('the closest points of a surface are those of the command', () => {
  const points = ['0,0.3,0', '-0.3,0.2,0.4', '3,3,3'];
  atEachFrame(
    (line) => {
      for (const { point, closest: all } of line.points) {
        const from = points[point].split(',').map(Number);
        for (const { index, distance, triangle, position } of all) {
          const closest = poses[index].closestPoint(from);
          assert.deepEqual(
            [closest.distance, closest.triangle, closest.position],
            [distance, triangle, position],
          );
          assert.ok(Math.abs(closest.weights.reduce((sum, weight) => sum + weight) - 1) < 1e-6);
          assert.equal(poses[index].closestPoint(from, { maxDistance: 0.99 * distance }), null);
        }
      }
    },
    ...['distance', ...points.map((point) => `--from=${point}`)],
  );
});

test('what is within a clearance is what the command finds', () => {
  let found = 0;
  atEachFrame(
    ({ pairs }) => {
      const near = pelt.clearance(a, b, 0.05);
      assert.deepEqual(Array.from(near.pairs), (pairs[0]?.triangles ?? []).flat());
      found += near.count;
      if (near.count > 3) assert.equal(pelt.clearance(a, b, 0.05, { maxPairs: 3 }).count, 3);
    },
    ...['check', '--clearance', '0.05', '--pairs'],
  );
  assert.ok(found > 1000, `${found} pairs`);
  assert.deepEqual(pelt.clearance(a, b, 0).pairs, pelt.collide(a, b).pairs);
});

test('the deepest vertices are those of the command', () => {
  let depths = 0;
  atEachFrame(
    ({ inside: [native] }) => {
      assert.equal(pelt.containment(a, b), 'none');
      for (const [of, others, expected] of [
        [a, b, native?.a_in_b ?? null],
        [b, a, native?.b_in_a ?? null],
      ]) {
        const deepest = pelt.deepestVertex(of, others);
        assert.equal(deepest?.depth, expected?.depth);
        if (expected === null) continue;
        ++depths;
        assert.deepEqual(deepest.position, expected.position);
        assert.deepEqual(
          [deepest.closest.position, deepest.closest.triangle],
          [expected.closest, expected.triangle],
        );
        const vertices = of.posedVertices().subarray(3 * deepest.vertex, 3 * deepest.vertex + 3);
        assert.deepEqual(Array.from(vertices), deepest.position);
        assert.equal(others.sideOf(deepest.position), 'inside');
      }
    },
    ...['check', '--inside'],
  );
  assert.equal(depths, 2);
});

test('a point lies inside, outside or on a surface', () => {
  poseAt(44);
  const { centre, radius } = a.exactBounds();
  assert.equal(a.sideOf([centre[0] + 2 * radius, centre[1], centre[2]]), 'outside');
  assert.equal(a.sideOf(a.posedVertices().subarray(300, 303)), 'on');
  const [first, second] = a.castAll([centre[0], centre[1], -9], [0, 0, 1]);
  assert.equal(a.sideOf([centre[0], centre[1], -9 + (first.t + second.t) / 2]), 'inside');
});

test('a body that another holds whole is found, though they touch nowhere', () => {
  const small = a.character.makePose();
  poseAt(44);
  const { position } = pelt.deepestVertex(b, a);
  const shrink = [0.001, 0, 0, 0, 0, 0.001, 0, 0, 0, 0, 0.001, 0, ...position, 1];
  small.setPalette(a.character.palette(null, 0, shrink));
  assert.equal(pelt.collide(small, a).count, 0);
  assert.equal(pelt.containment(small, a), 'a_in_b');
  assert.equal(pelt.containment(a, small), 'b_in_a');
  small.delete();
});

test('a surface that is not closed has no inside', () => {
  assert.equal(a.isClosed, true);
  const positions = Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0);
  const uri = `data:application/octet-stream;base64,${Buffer.from(positions.buffer).toString('base64')}`;
  const gltf = {
    asset: { version: '2.0' },
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0 }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0 } }] }],
    accessors: [{ bufferView: 0, componentType: 5126, type: 'VEC3', count: 3 }],
    bufferViews: [{ buffer: 0, byteLength: 36 }],
    buffers: [{ byteLength: 36, uri }],
  };
  const sheet = pelt.readCharacter(new TextEncoder().encode(JSON.stringify(gltf)), {
    name: 'sheet',
  });
  const pose = sheet.makePose();
  assert.equal(pose.isClosed, false);
  const refusal = { code: 'invalid_argument', message: /sheet.*not closed/ };
  assert.throws(() => pose.sideOf([0, 0, 0]), refusal);
  assert.throws(() => pelt.deepestVertex(a, pose), refusal);
  sheet.delete();
});

test('the work of every query can be read', () => {
  const ball = { kind: 'sphere', centre: [0, 0, 0], radius: 0.3 };
  const queries = {
    collide: () => pelt.collide(a, b),
    intersects: () => pelt.intersects(a, b),
    isWithin: () => pelt.isWithin(a, b, 0.01),
    collideMoving: () => pelt.collideMoving({ from: a, to: a }, { from: b, to: b }),
    firstContact: () => pelt.firstContact({ from: a, to: a }, { from: b, to: b }),
    touchWhileMoving: () => pelt.touchWhileMoving({ from: a, to: a }, { from: b, to: b }),
    distance: () => pelt.distance(a, b),
    describeContacts: () => pelt.describeContacts(a, b, pelt.collide(a, b).pairs),
    containment: () => pelt.containment(a, b),
    bounds: () => a.bounds(1),
    exactBounds: () => a.exactBounds(),
    cast: () => a.cast([0, 0, 9], [0, 0, -1]),
    castAny: () => a.castAny([0, 0, 9], [0, 0, -1]),
    castAll: () => a.castAll([0, 0, 9], [0, 0, -1]),
    classify: () => a.classify(ball),
    intersectsRegion: () => a.intersectsRegion(ball),
    findTriangles: () => a.findTriangles(ball),
    closestPoint: () => a.closestPoint([0, 0, 9]),
  };
  const workOf = (query) => {
    poseAt(44); // closes all nodes
    b.exactBounds();
    const before = pelt.lastStats;
    const { stats } = query();
    if (stats) assert.deepEqual({ ...stats, ...pelt.lastStats }, stats);
    assert.notDeepEqual(pelt.lastStats, before, 'the work of the query before');
    return pelt.lastStats;
  };
  for (const [name, query] of Object.entries(queries)) {
    const work = workOf(query);
    assert.ok(work.nodePairs + work.refits + work.trianglePairs > 0, name);
    assert.deepEqual(workOf(query), work, name);
  }
});

test('regions, rays and distances that break a rule are refused', () => {
  refused(
    () => a.classify({ kind: 'ball' }),
    /region.kind: expected one of .*"sphere".*, found "ball"/,
  );
  refused(() => a.classify({ kind: 'sphere', centre: [0, 0, 0], radius: -1 }), /region.radius/);
  refused(
    () => a.classify({ kind: 'sphere', center: [0, 0, 0], radius: 1 }),
    /unknown key "center"/,
  );
  refused(() => a.classify({ kind: 'box', low: [0, 0, 0] }), /region.high/);
  const faces = Array.from({ length: 65 }, () => ({ normal: [0, 1, 0], offset: 0 }));
  refused(() => a.classify({ kind: 'polyhedron', faces }), /region.faces.*64/);
  const viewProjection = new Array(16).fill(3e38);
  refused(() => a.classify({ kind: 'frustum', viewProjection }), /region.viewProjection\[0\]/);
  refused(() => a.cast([0, 0, 0], [0, 0, 1], { facing: 'left' }), /facing.*"left"/);
  refused(() => a.cast([0, 0, 0], [0, 0, 1], { minT: NaN }), /minT/);
  refused(() => a.castAll([0, 0], [0, 0, 1]), /origin: expected 3 numbers/);
  refused(() => a.closestPoint([0, 0, NaN]), /point/);
  refused(() => pelt.clearance(a, b, -1), /tolerance/);
  refused(() => pelt.clearance(a, b, 1, { maxContacts: 3 }), /unknown option "maxContacts"/);
  refused(() => pelt.isWithin(a, a, 1), /different poses/);
  refused(() => pelt.distance(a, b, { tolerance: -1 }), /tolerance/);
});
