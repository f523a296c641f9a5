/**
 * Uses all that the package exports, as a user would: package.test.mjs compiles it and queries.ts
 * against the installed package, runs it, and sees to it that every name of pelt.d.ts occurs.
 */

import {
  type Box,
  type Bytes,
  type Character,
  type Clip,
  type ContactHash,
  type CountedContacts,
  type CreatureOptions,
  type Crowd,
  type CrowdContacts,
  type CrowdMovingContacts,
  type ErrorCode,
  type FaceOptions,
  type Files,
  type Instance,
  loadPelt,
  type MeshArrays,
  type MeshoptDecode,
  type ModelOptions,
  type NamePair,
  type Part,
  type Pelt,
  PeltError,
  type Pose,
  type ReadOptions,
  type Scene,
  type SceneParts,
  type SelfChoices,
} from 'pelt-collision';
import {
  check,
  useContacts,
  useDistance,
  useMotion,
  usePose,
  useSearch,
  useSelf,
  useStats,
} from './queries.js';

const decode: MeshoptDecode = (
  target: Uint8Array,
  count: number,
  size: number,
  source: Uint8Array,
  mode: string,
  filter?: string,
) => {
  throw new Error(`${target.length} ${count} ${size} ${source.length} ${mode} ${filter ?? ''}`);
};

const modelOptions: ModelOptions = {
  meshoptDecode: decode,
  renormalise: true,
  weld: true,
  skinning: 'dual-quaternion',
  noUnskinned: false,
  exclude: ['cape'],
  samples: 2,
};
const creatureOptions: CreatureOptions = {
  name: 'walker',
  clips: ['walk'],
  triangles: 2000,
  joints: 30,
  seed: 2,
  skinning: 'linear',
};
const faceOptions: FaceOptions = {
  name: 'face',
  clips: ['talk'],
  triangles: 1000,
  seed: 2,
  skinning: 'dual-quaternion',
};

function readMissing(pelt: Pelt): ErrorCode {
  const files: Files = { 'a.bin': new Uint8Array(3) };
  const options: ReadOptions = { ...modelOptions, name: 'a.gltf', files, clips: [] };
  try {
    const bytes: Bytes = new ArrayBuffer(3);
    const read: Character = pelt.readCharacter(bytes, options);
    read.delete();
  } catch (error) {
    if (error instanceof PeltError && error.cause === undefined) return error.code;
  }
  throw new Error('three bytes were taken for a character');
}

function useCharacter(character: Character): void {
  const { name, vertexCount, triangleCount, jointCount, nodeCount, levelCount } = character;
  check(name === 'walker' && nodeCount > levelCount, 'sizes');
  const parts: readonly Part[] = character.parts;
  for (const { name, firstTriangle, triangleCount, skinned } of parts) {
    check(name !== '' && firstTriangle === 0 && triangleCount === 2000 && skinned, 'part');
  }
  const clips: readonly Clip[] = character.clips;
  for (const { name, seconds } of clips) check(name !== '' && seconds > 0, 'clip');
  const names: readonly string[] = [
    ...character.jointNames,
    ...character.morphTargetNames,
    ...character.warnings,
  ];
  check(names.length >= jointCount, 'names');
  const triangles: Uint32Array = character.triangles;
  const restPositions: Float32Array = character.restPositions;
  check(triangles.length === 3 * triangleCount, 'triangles');
  check(restPositions.length === 3 * vertexCount, 'restPositions');
  const triangleParts: Uint16Array = character.triangleParts;
  const triangleJoints: Uint16Array = character.triangleJoints;
  check(triangleParts.length === triangleJoints.length, 'triangleJoints');
  const { low, high }: Box = character.extent;
  check(low[1] < high[1], 'extent');
}

function refusesDualQuaternions(pose: Pose): boolean {
  try {
    pose.setDualQuaternions(new Float32Array(8 * pose.character.jointCount));
  } catch (error) {
    return error instanceof PeltError;
  }
  return false;
}

function useMorphs(face: Character): void {
  const pose = face.makePose(0);
  check(pose.part === 0 && pose.nodeCount <= face.nodeCount, 'part');
  const weights: Float32Array = face.morphWeights('talk', 0.5);
  pose.setMorphWeights(face.morphWeights(null, 0, weights));
  check(refusesDualQuaternions(pose), 'linear blend skinning');
  pose.delete();
}

function useScene(pelt: Pelt, walker: Character): void {
  const self: SelfChoices = {
    wanted: 'also',
    rings: 2,
    dropsAtRest: true,
    always: null,
    dropsNearJoints: true,
  };
  const parts: SceneParts = {
    self,
    name: 'own',
    characters: [walker],
    instances: [
      { character: 0, clip: 'walk' },
      { character: 0, translation: [0.1, 0, 0] },
    ],
    frameCount: 10,
    fps: 24,
  };
  const scene: Scene = pelt.makeScene(parts);
  check(scene.self.rings === 2, 'self');
  const instance: Instance = {
    character: 0,
    clip: null,
    start: 0,
    speed: 1,
    translation: [0, 0, 0],
    rotation: [0, 1, 0, 0],
    scale: 1,
    velocity: [0, 0, 1],
    morphWeights: {},
  };
  scene.instances.push(instance);
  check(scene.name === 'own' && scene.frameCount / scene.fps < 1, 'scene');
  const poses = scene.instances.map(({ character }) => scene.characters[character]!.makePose());
  poses.forEach((pose, i) => scene.setPose(pose, i, 3));
  const [a, b] = [poses[0]!, poses[1]!];
  check(a.character === walker, 'character');
  usePose(a);
  useContacts(pelt, a, b);
  useMotion(pelt, a, b);
  useSearch(pelt, a, b);
  useSelf(pelt, a);
  useDistance(pelt, a, b);
  useCrowd(pelt, scene);
  for (const pose of poses) pose.delete();
}

function useCrowd(pelt: Pelt, scene: Scene): void {
  const crowd: Crowd = pelt.makeCrowd();
  for (const { character } of scene.instances) {
    const instance: number = crowd.add(scene.characters[character]!, null);
    crowd.setPalette(instance, Float64Array.from(scene.palette(instance, 3)));
    crowd.setMorphWeights(instance, scene.morphWeights(instance, 3));
    crowd.setSelfFilter(instance, null);
  }
  crowd.filterParts([], scene.characters[0]!.makeSelfFilter());
  const pairs: NamePair[] = [['nobody', 'no*'], ...scene.ignore];
  crowd.ignore(pairs);
  const { count, contacts, ignored, leftOut, stats }: CrowdContacts = crowd.collide();
  check(contacts.length === 4 * count && ignored + leftOut.rings === 0, 'crowd');
  const counted: CountedContacts = crowd.withoutIgnored(contacts);
  check(counted.contacts.length === contacts.length && counted.ignored === 0, 'counted');
  useStats(stats);
  const palettes: [Float32Array, Float32Array] = [scene.palette(0, 3), scene.palette(0, 4)];
  crowd.beginStep();
  crowd.setMotion(0, ...palettes);
  const { setMotionDualQuaternions }: Crowd = crowd;
  check(setMotionDualQuaternions.length === 3, 'instance, from and to');
  const moving: CrowdMovingContacts = crowd.collideMoving({ leaveOutStart: true });
  check(moving.contacts.length === 4 * moving.times.length, 'crowd in motion');
  const hash: ContactHash = pelt.makeContactHash();
  hash.addCrowd(3, contacts);
  hash.add(4, 0, 1, new Uint32Array(2));
  const value: string = hash.value;
  check(value.length === 16, 'hash');
  hash.delete();
  crowd.delete();
}

function useMesh(pelt: Pelt, { restPositions, triangles }: Character): void {
  const arrays: MeshArrays = {
    name: 'statue',
    restPositions,
    triangles,
    weld: false,
    offsetCaps: 1,
  };
  const statue: Character = pelt.makeCharacter(arrays);
  check(statue.jointCount === 1, 'mesh');
  const pose: Pose = statue.makePose();
  pose.setVertices(restPositions);
  pose.setOffsets(restPositions.map(() => 2));
  check(pose.checkOffsets() === statue.vertexCount, 'offsets');
  statue.delete();
}

function useDemo(pelt: Pelt): void {
  const text = Uint8Array.from(pelt.demoScene, (letter) => letter.charCodeAt(0));
  const files: Files = new Map([['demo.json', text]]);
  const scene = pelt.readScene('demo.json', files, { ...modelOptions, exclude: [] });
  check(scene.instances.length === 2, 'demo');
  scene.delete();
}

/** Each line is wrong, and the compiler says so. Never called. */
export function misuse(pelt: Pelt, pose: Pose, character: Character, scene: Scene): void {
  // @ts-expect-error a name is needed
  pelt.readCharacter(new Uint8Array(3), {});
  // @ts-expect-error there is no such option
  pelt.generateCreature({ triangels: 2000 });
  // @ts-expect-error a number, and no text
  pelt.generateFace({ triangles: '2000' });
  // @ts-expect-error a pose, and no character
  pelt.collide(pose, character);
  // @ts-expect-error a motion, and no pose
  pelt.collideMoving(pose, pose);
  // @ts-expect-error there is no such order
  pelt.makeSearch(pose, pose, { order: 'fast' });
  // @ts-expect-error null has no distance
  pelt.distance(pose, pose).distance;
  // @ts-expect-error there may be no hit
  pose.cast([0, 0, 0], [0, 0, 1]).triangle;
  // @ts-expect-error there is no such kind
  pose.classify({ kind: 'ball', centre: [0, 0, 0], radius: 1 });
  // @ts-expect-error a sphere has a radius
  pose.classify({ kind: 'sphere', centre: [0, 0, 0] });
  // @ts-expect-error nothing may be near enough
  pose.closestPoint([0, 0, 0]).distance;
  // @ts-expect-error floats or doubles
  pose.setPalette(new Int32Array(16));
  // @ts-expect-error a clip is a name or null
  character.palette(3, 0);
  // @ts-expect-error for reading only
  character.name = 'other';
  // @ts-expect-error three numbers
  scene.instances[0]!.translation = [0, 1];
  // @ts-expect-error instances belong to a character
  pelt.makeScene({ characters: [character], instances: [{ clip: 'walk' }] });
  // @ts-expect-error for reading only
  pelt.version = '2';
  // @ts-expect-error only Pelt makes errors
  new PeltError();
}

const pelt = await loadPelt();
check(/^\d+\.\d+\.\d+/.test(pelt.version), 'version');
check(readMissing(pelt) === 'malformed_file', 'the code of an error');
check(!pelt.hasEnded, 'hasEnded');
const walker = pelt.generateCreature(creatureOptions);
useCharacter(walker);
useScene(pelt, walker);
useMorphs(pelt.generateFace(faceOptions));
useMesh(pelt, walker);
useDemo(pelt);
check(walker.palette('walk', 0.5, undefined, new Float32Array(16 * 30)).length === 480, 'palette');
