// palette.mjs PACKAGE: checks the statements of bindings/wasm/README.md about three.js's bones: the
// palette of a pose is boneMatrices[j] x bindMatrix, names with dots are in userData.name, and a
// file with unskinned parts must be read with noUnskinned.

import assert from 'node:assert/strict';
import path from 'node:path';
import { pathToFileURL } from 'node:url';
import * as THREE from 'three';
import { skinnedRock } from '../wasm/gltf.mjs';
import { loadBytes } from './three_pose.mjs';

const { loadPelt } = await import(pathToFileURL(path.resolve(process.argv[2], 'pelt.mjs')));
const pelt = await loadPelt();

/** A skinned rock whose joint has a dot in its name, and a stone that rides on that joint. */
function rockWithStone() {
  const gltf = JSON.parse(new TextDecoder().decode(skinnedRock({ translation: [1, 2, 3] })));
  gltf.nodes[1].name = 'hand.r';
  gltf.nodes[1].children = [2];
  gltf.nodes.push({ name: 'stone', mesh: 1, translation: [0, 5, 0] });
  const { POSITION } = gltf.meshes[0].primitives[0].attributes;
  gltf.meshes.push({ primitives: [{ attributes: { POSITION }, indices: 1 }] });
  return new TextEncoder().encode(JSON.stringify(gltf));
}

/** The example of the README. */
function paletteOf(mesh) {
  const { skeleton, bindMatrix } = mesh;
  const palette = new Float32Array(16 * skeleton.bones.length);
  const matrix = new THREE.Matrix4();
  skeleton.update();
  for (let j = 0; j < skeleton.bones.length; ++j)
    matrix.fromArray(skeleton.boneMatrices, 16 * j).multiply(bindMatrix).toArray(palette, 16 * j);
  return palette;
}

/** The vertices that three.js draws, in world space. */
function drawnBy(mesh) {
  const drawn = [];
  for (let v = 0; v < mesh.geometry.attributes.position.count; ++v) {
    const position = mesh.getVertexPosition(v, new THREE.Vector3());
    drawn.push(...position.applyMatrix4(mesh.matrixWorld).toArray());
  }
  return drawn;
}

function assertNear(ours, theirs) {
  assert.equal(ours.length, theirs.length);
  ours.forEach((x, i) => assert.ok(Math.abs(x - theirs[i]) < 1e-5, `${i}: ${x}, not ${theirs[i]}`));
}

/** The same placement by hand, chosen so that a wrong rule gives another result. */
function place(scene, mesh) {
  scene.position.set(7, -3, 2);
  scene.rotation.set(0.3, 0.9, -0.2);
  mesh.position.set(-1, 4, 0.5);
  mesh.rotation.set(-0.6, 0.1, 0.8);
  mesh.skeleton.bones[0].rotation.set(0.5, 0.7, 0.2);
  scene.updateMatrixWorld(true);
}

const bytes = rockWithStone();
const { scene } = await loadBytes(bytes.buffer);
let mesh = null;
scene.traverse((object) => {
  if (object.isSkinnedMesh) mesh = object;
});
assert.equal(mesh.bindMode, 'attached');

const [bone] = mesh.skeleton.bones;
assert.equal(bone.name, 'handr');
assert.equal(bone.userData.name, 'hand.r');

const rock = pelt.readCharacter(bytes, { name: 'rock.gltf', noUnskinned: true });
assert.deepEqual(rock.jointNames, mesh.skeleton.bones.map((bone) => bone.userData.name ?? bone.name));
const pose = rock.makePose();

place(scene, mesh);
pose.setPalette(paletteOf(mesh));
assertNear(pose.posedVertices(), drawnBy(mesh));

// Bound with a matrix, as by bind() without an argument.
mesh.bind(mesh.skeleton, new THREE.Matrix4().makeRotationX(0.4).setPosition(1, 2, 3));
place(scene, mesh);
pose.setPalette(paletteOf(mesh));
const drawn = drawnBy(mesh);
assertNear(pose.posedVertices(), drawn);

// The world matrix of the mesh must not be multiplied in.
const wrong = new THREE.Matrix4().fromArray(paletteOf(mesh)).premultiply(mesh.matrixWorld);
pose.setPalette(new Float32Array(wrong.toArray()));
assert.throws(() => assertNear(pose.posedVertices(), drawn));

// With the stone, the character has a joint that the skeleton lacks.
const withStone = pelt.readCharacter(bytes, { name: 'rock.gltf' });
assert.deepEqual(withStone.jointNames, ['hand.r', 'stone']);
assert.throws(() => withStone.makePose().setPalette(paletteOf(mesh)), /palette/);
console.log('three.js draws what the palette of its bones poses');
