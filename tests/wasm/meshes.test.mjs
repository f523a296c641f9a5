/** Characters that are made of arrays. */

import assert from 'node:assert/strict';
import test from 'node:test';
import { rock } from './gltf.mjs';
import { bytesInUse, pelt, refused } from './support.mjs';

const creature = pelt.generateCreature({ triangles: 3000, joints: 30 });
const arrays = { restPositions: creature.restPositions, triangles: creature.triangles };

/** A column-major matrix that turns about y and then moves. */
function placed(angle, x, y, z) {
  const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
  return Float32Array.of(cos, 0, -sin, 0, 0, 1, 0, 0, sin, 0, cos, 0, x, y, z, 1);
}

test('a mesh is one part that follows one joint', () => {
  const mesh = pelt.makeCharacter({ ...arrays, name: 'statue' });
  const { name, parts, clips, jointNames, morphTargetNames, warnings } = mesh;
  const [{ firstTriangle, triangleCount, skinned }] = parts;
  assert.deepEqual([name, jointNames, clips.length, morphTargetNames.length], ['statue', ['statue'], 0, 0]);
  assert.deepEqual([parts.length, firstTriangle, triangleCount, skinned], [1, 0, 3000, false]);
  assert.deepEqual([mesh.restPositions, mesh.triangles, warnings.length],
    [arrays.restPositions, arrays.triangles, 0]);
  assert.ok(mesh.triangleJoints.every((joint) => joint === 0));
  mesh.delete();
  assert.equal(pelt.makeCharacter(arrays).name, 'mesh');
});

test('a palette of one matrix places it like any character', () => {
  const mesh = pelt.makeCharacter(arrays);
  const matrices = [placed(0, 0, 0, 0), placed(0.7, 0.1, 0.05, 0.1)];
  const [stone, other] = matrices.map((matrix) => {
    const pose = mesh.makePose();
    pose.setPalette(mesh.palette(null, 0, matrix));
    return pose;
  });
  assert.deepEqual(stone.posedVertices(), mesh.restPositions);
  assert.notDeepEqual(other.posedVertices(), mesh.restPositions);
  const { count, pairs } = pelt.collide(stone, other);
  assert.ok(count > 500, `${count} contacts`);
  const still = pelt.makeCharacter({ ...arrays, restPositions: other.posedVertices() });
  const there = still.makePose();
  assert.deepEqual(pelt.collide(stone, there).pairs, pairs);
  for (const made of [stone, other, there, still, mesh]) made.delete();
});

test('indices may have 16 bits, and arrays are copied', () => {
  const restPositions = arrays.restPositions.slice();
  const triangles = Uint16Array.from(arrays.triangles);
  pelt.makeCharacter({ restPositions, triangles }).delete(); // the engine keeps buffers for later calls
  const before = bytesInUse();
  const mesh = pelt.makeCharacter({ restPositions, triangles });
  restPositions.fill(NaN);
  triangles.fill(0);
  assert.deepEqual([mesh.restPositions, mesh.triangles], [arrays.restPositions, arrays.triangles]);
  mesh.delete();
  assert.equal(bytesInUse(), before);
});

/** A tetrahedron whose triangles have vertices of their own. */
const loose = (() => {
  const { restPositions, triangles } = pelt.readCharacter(rock(), { name: 'rock' });
  const corners = [...triangles].flatMap((v) => [...restPositions.subarray(3 * v, 3 * v + 3)]);
  return { restPositions: Float32Array.from(corners), triangles: Uint32Array.from(corners.keys()).subarray(0, 12) };
})();

test('vertices are merged if the option says so', () => {
  const isClosed = (options) => pelt.makeCharacter({ ...loose, ...options }).makePose().isClosed;
  assert.deepEqual([isClosed({}), isClosed({ weld: false }), isClosed({ weld: true })], [false, false, true]);
});

test('wrong meshes are refused with their names', () => {
  const made = (change) => () => pelt.makeCharacter({ ...arrays, name: 'statue', ...change });
  refused(() => pelt.makeCharacter(), 'mesh: expected an object, found nothing');
  refused(made({ normals: arrays.restPositions }), /^mesh: unknown key "normals"/);
  refused(made({ restPositions: undefined }), 'mesh.restPositions: expected a Float32Array, found nothing');
  refused(made({ restPositions: [0, 1, 2] }), 'mesh.restPositions: expected a Float32Array, found an Array');
  refused(made({ restPositions: new Float32Array(4) }), /^mesh.restPositions: expected a multiple of 3/);
  refused(made({ triangles: new Float32Array(3) }), /^mesh.triangles: expected a Uint32Array/);
  refused(made({ triangles: new Uint16Array(4) }), /^mesh.triangles: expected a multiple of 3/);
  refused(made({ triangles: new Uint32Array(0) }), 'statue: triangles is empty');
  refused(made({ triangles: Uint32Array.of(0, 1, 5000) }), /^statue: triangles\[0\] .*5000/);
  const restPositions = arrays.restPositions.slice();
  restPositions[7] = NaN;
  refused(made({ restPositions }), /^statue: restPositions\[2\] .*nan/);
  refused(made({ weld: 1 }), 'mesh.weld: expected true or false, found 1');
  refused(made({ name: 1 }), 'mesh.name: expected a string, found 1');
});
