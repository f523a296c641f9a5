// Poses a glTF file with three.js: loaded by its GLTFLoader, moved by its AnimationMixer, skinned
// by its SkinnedMesh. three.js is written for browsers; replacements for what Node lacks are at the
// top.

import { readFile } from 'node:fs/promises';
import * as THREE from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { MeshoptDecoder } from 'three/addons/libs/meshopt_decoder.module.js';

globalThis.self ??= globalThis;
globalThis.ProgressEvent ??= class ProgressEvent extends Event {};

// three.js would make the first four weights sum to 1 and ignore the others.
const normaliseFourWeights = THREE.SkinnedMesh.prototype.normalizeSkinWeights;
THREE.SkinnedMesh.prototype.normalizeSkinWeights = function () {
  if (influenceSets(this).length === 1) normaliseFourWeights.call(this);
};

/** The attributes [skinIndex, skinWeight], [joints_1, weights_1] ... of a skinned mesh. */
function influenceSets(mesh) {
  const { attributes } = mesh.geometry;
  const sets = [[attributes.skinIndex, attributes.skinWeight]];
  while (attributes[`joints_${sets.length}`]) {
    sets.push([attributes[`joints_${sets.length}`], attributes[`weights_${sets.length}`]]);
  }
  return sets;
}

/**
 * glTF's rotations are unit quaternions. Where a file has rounded them (to three decimals, to
 * bytes), Pelt makes them so and three.js scales the mesh a little, which is not compared here.
 */
function normaliseRotations(track) {
  const isSpline = track.values.length !== track.times.length * 4;
  if (track.ValueTypeName !== 'quaternion' || isSpline) return;
  const rotation = new THREE.Quaternion();
  for (let i = 0; i < track.values.length; i += 4) {
    rotation.fromArray(track.values, i).normalize().toArray(track.values, i);
  }
}

/** A file's bytes, an ArrayBuffer, as GLTFLoader makes objects of them. */
export function loadBytes(data) {
  return new GLTFLoader().setMeshoptDecoder(MeshoptDecoder).parseAsync(data, '');
}

export async function loadModel(path) {
  const bytes = await readFile(path);
  const data = bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength);
  const gltf = await loadBytes(data);
  gltf.scene.traverse((object) => object.quaternion.normalize());
  for (const clip of gltf.animations) {
    clip.tracks.forEach(normaliseRotations);
  }
  return { scene: gltf.scene, clips: gltf.animations, mixer: new THREE.AnimationMixer(gltf.scene) };
}

/** The corners of all triangles in scene order, nine numbers each. `clip` null: the default pose. */
export function poseCorners(model, clip, seconds) {
  model.mixer.stopAllAction();
  if (clip) {
    const action = model.mixer.clipAction(clip);
    action.setLoop(THREE.LoopOnce, 1);
    action.clampWhenFinished = true;
    action.reset().play();
    model.mixer.setTime(seconds);
  }
  model.scene.updateMatrixWorld(true);
  const corners = [];
  model.scene.traverse((object) => {
    if (object.isMesh) appendCorners(object, corners);
  });
  return corners;
}

function appendCorners(mesh, corners) {
  const positions = posedVertices(mesh);
  const { index } = mesh.geometry;
  const count = index ? index.count : positions.length;
  for (let i = 0; i < count; ++i) corners.push(...positions[index ? index.getX(i) : i]);
}

function posedVertices(mesh) {
  const pose = mesh.isSkinnedMesh && influenceSets(mesh).length > 1 ? poseByAllSets : poseByThree;
  const positions = [];
  for (let i = 0; i < mesh.geometry.attributes.position.count; ++i) {
    positions.push(pose(mesh, i).toArray());
  }
  return positions;
}

function poseByThree(mesh, vertex) {
  return mesh.getVertexPosition(vertex, new THREE.Vector3()).applyMatrix4(mesh.matrixWorld);
}

/** three.js skins with four influences; the same sum over three.js's bones for more. */
function poseByAllSets(mesh, vertex) {
  const rest = THREE.Mesh.prototype.getVertexPosition.call(mesh, vertex, new THREE.Vector3());
  const { bones, boneInverses } = mesh.skeleton;
  const posed = new THREE.Vector3();
  let weightSum = 0;
  for (const [joints, weights] of influenceSets(mesh)) {
    for (let k = 0; k < 4; ++k) {
      const weight = weights.getComponent(vertex, k);
      if (weight === 0) continue;
      const joint = joints.getComponent(vertex, k);
      const matrix = new THREE.Matrix4().multiplyMatrices(bones[joint].matrixWorld, boneInverses[joint]);
      posed.addScaledVector(rest.clone().applyMatrix4(matrix), weight);
      weightSum += weight;
    }
  }
  return posed.divideScalar(weightSum);
}
