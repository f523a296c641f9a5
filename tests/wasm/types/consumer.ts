/**
 * Uses all that the package exports, as a user would: package.test.mjs compiles it against the
 * installed package, runs it, and sees to it that every name of pelt.d.ts occurs.
 */

import {
  type Bounds,
  type Box,
  type BoxRegion,
  type Capsule,
  type CastOptions,
  type Bytes,
  type Character,
  type Clip,
  type ClearanceOptions,
  type ClosestPoint,
  type ClosestPointOptions,
  type ContactCurve,
  type ContactGeometry,
  type ContactHash,
  type ContactTally,
  ContactKind,
  type ContactPatch,
  type CountedContacts,
  type ConvexPolyhedron,
  type Contacts,
  type CollideOptions,
  type CollisionSearch,
  type CreatureOptions,
  type Crowd,
  type CrowdContacts,
  type CrowdMovingContacts,
  type Distance,
  type DistanceOptions,
  type ErrorCode,
  type Face,
  type FaceOptions,
  type Feature,
  FeatureKind,
  type Files,
  type FirstContactOptions,
  type Frustum,
  type HalfSpace,
  type Instance,
  type LeftOut,
  loadPelt,
  type MeshArrays,
  type MeshoptDecode,
  type ModelOptions,
  type Motion,
  type MovingColumns,
  type MovingContact,
  type MovingContacts,
  type MovingOptions,
  type MovingStats,
  type NamePair,
  type NearPairs,
  type NodeBoxes,
  NodeState,
  type OpenRegions,
  type OrientedBox,
  type Part,
  type Pelt,
  PeltError,
  type Penetration,
  type Pose,
  type QueryStats,
  type RayHit,
  type ReadOptions,
  type Region,
  type Scene,
  type SceneParts,
  type SearchOptions,
  type SelfChoices,
  type SelfContacts,
  type SelfFilter,
  type SelfFilterOptions,
  type SelfMovingContacts,
  type Sphere,
  type SurfacePoint,
  type TrianglesInRegion,
  type Vector,
} from 'pelt-collision';

type Point = readonly [number, number, number];

function check(holds: boolean, what: string): void {
  if (!holds) throw new Error(what);
}

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

function usePose(pose: Pose): void {
  useStats(pose.openAll());
  const vertices: Float32Array = pose.posedVertices();
  check(pose.normals(vertices) === vertices, 'out');
  const bounds: Bounds[] = [pose.bounds(), pose.bounds(3), pose.exactBounds()];
  for (const { box, centre, radius } of bounds) {
    const corner: Point = box.high;
    check(corner[0] >= centre[0] && radius > 0, 'bounds');
  }
  const opened: number = pose.openedNodeCount;
  const { count, boxes, states }: NodeBoxes = pose.nodeBoxes(2);
  check(boxes.length === 6 * count && opened >= 0, 'nodeBoxes');
  const known: number[] = [NodeState.untouched, NodeState.refitted, NodeState.opened];
  check(
    states.every((state) => known.includes(state)),
    'states',
  );
  useRays(pose);
  useRegions(pose);
  usePoints(pose);
}

function useRays(pose: Pose): void {
  const options: CastOptions = { minT: 0, maxT: 100, facing: 'front' };
  const ray: [Vector, Vector] = [[0, 0.9, 9], Float32Array.of(0, 0, -1)];
  const hit: RayHit | null = pose.cast(...ray, options);
  const hits: RayHit[] = pose.castAll(...ray, options);
  const isHit: boolean = pose.castAny(...ray);
  check(isHit === (hit !== null), 'castAny');
  for (const { triangle, t, weights, normal } of hits) {
    const numbers: number[] = [triangle, t, ...weights, ...normal];
    check(numbers.length === 8, 'hit');
  }
}

function useRegions(pose: Pose): void {
  const face: Face = { normal: [0, 1, 0], offset: 9 };
  const halfSpace: HalfSpace = { kind: 'halfSpace', ...face };
  const box: BoxRegion = { kind: 'box', low: [-9, -9, -9], high: [9, 9, 9] };
  const turned: OrientedBox = {
    kind: 'orientedBox',
    centre: [0, 0, 0],
    axes: [
      [0, 1, 0],
      [0, 0, 1],
      [1, 0, 0],
    ],
    half: [9, 9, 9],
  };
  const polyhedron: ConvexPolyhedron = { kind: 'polyhedron', faces: [face] };
  const sphere: Sphere = { kind: 'sphere', centre: [0, 1, 0], radius: 9 };
  const capsule: Capsule = { kind: 'capsule', a: [0, 0, 0], b: [0, 2, 0], radius: 9 };
  const viewProjection = [0.1, 0, 0, 0, 0, 0.1, 0, 0, 0, 0, 0.1, 0, 0, 0, 0, 1];
  const frustum: Frustum = { kind: 'frustum', viewProjection, depth: 'minusOneToOne' };
  const regions: Region[] = [halfSpace, box, turned, polyhedron, sphere, capsule, frustum];
  for (const region of regions) {
    check(pose.classify(region) === 'inside' && pose.intersectsRegion(region), region.kind);
    const { intersecting, inside, stats }: TrianglesInRegion = pose.findTriangles(region);
    check(intersecting.length === inside.length && !stats.cutShort, 'findTriangles');
  }
}

function usePoints(pose: Pose): void {
  const options: ClosestPointOptions = { maxDistance: 50 };
  const closest: ClosestPoint | null = pose.closestPoint([0, 9, 0], options);
  if (closest === null) throw new Error('closestPoint');
  const { distance, triangle, position, weights } = closest;
  check(distance + triangle + weights.length > 3 && position.length === 3, 'closest');
  useStats(closest.stats);
  check(pose.isClosed && pose.sideOf([0, 9, 0]) === 'outside', 'sideOf');
}

function useStats(stats: QueryStats): void {
  const { nodePairs, refits, posedVertices, trianglePairs, displacements, clampedOffsets } = stats;
  check(nodePairs + refits + posedVertices + trianglePairs + displacements > 0, 'stats');
  check(stats.cutShort === false && clampedOffsets === 0, 'cutShort');
}

function useContacts(pelt: Pelt, a: Pose, b: Pose): void {
  const found: Contacts = pelt.collide(a, b);
  const { count, pairs, stats } = found;
  check(count > 0 && pairs.length === 2 * count, 'pairs');
  useStats(stats);
  const options: CollideOptions = { firstContact: true, maxContacts: 4 };
  check(pelt.collideEagerly(a, b, options).count === 1, 'firstContact');
  useStats(b.openAll());
  const touch: boolean = pelt.intersects(a, b);
  check(touch, 'intersects');
  useStats(pelt.lastStats);
  const geometry: ContactGeometry = pelt.describeContacts(a, b, pairs);
  const floats: Float32Array[] = [geometry.segments, geometry.normals, geometry.depths];
  check(floats[2]?.length === count && geometry.joints.length === 2 * count, 'geometry');
  const kinds: number[] = Object.values(ContactKind);
  const all =
    ContactKind.segment + ContactKind.point + ContactKind.coplanar + ContactKind.collapsed;
  check(all === 6 && geometry.kinds.every((kind) => kinds.includes(kind)), 'kinds');
  const curves: readonly ContactCurve[] = geometry.curves;
  for (const { isClosed, points } of curves) check(isClosed || points.length > 3, 'curve');
  const patches: readonly ContactPatch[] = geometry.patches;
  for (const { contacts, length, depth, point, normal, jointA, jointB } of patches) {
    const numbers: number[] = [length, depth, ...point, ...normal, jointA, jointB];
    check(contacts.length > 0 && numbers.length === 10, 'patch');
  }
}

function useSelf(pelt: Pelt, pose: Pose): void {
  const triangles = pose.character.triangleCount;
  const options: SelfFilterOptions = {
    rings: 1,
    takesPart: new Uint8Array(triangles).fill(1),
    atRest: Uint32Array.of(0, 1),
    always: Uint32Array.of(2, 3),
    nearJoints: true,
    jointPairs: Uint16Array.of(0, 1),
    groups: new Uint16Array(triangles),
    groupPairs: Uint16Array.of(1, 1),
  };
  const filter: SelfFilter = pose.character.makeSelfFilter(options, pose.part);
  check(filter.character === pose.character && filter.part === pose.part, 'filter');
  const { count, pairs, stats, leftOut }: SelfContacts = pelt.selfCollide(pose, filter);
  useStats(stats);
  const { takesPart, rings, atRest, always, joints, groups }: LeftOut = leftOut;
  check(takesPart + rings + atRest + always + joints + groups >= 0, 'leftOut');
  const tally: ContactTally = pelt.makeContactTally();
  tally.add(pairs);
  const inAll: Uint32Array = tally.inShareOfPoses(1);
  check(tally.poseCount === 1 && inAll.length === pairs.length, 'tally');
  tally.delete();
  const intersects: boolean = pelt.selfIntersects(pose, filter);
  check(intersects === count > 0, 'selfIntersects');
  const geometry: ContactGeometry = pelt.describeSelfContacts(pose, pairs);
  check(geometry.depths.length === count, 'describeSelfContacts');
  filter.delete();
}

function useDistance(pelt: Pelt, a: Pose, b: Pose): void {
  const options: DistanceOptions = { maxDistance: 50, tolerance: 0 };
  const closest: Distance | null = pelt.distance(a, b, options);
  if (closest === null) throw new Error('distance');
  useStats(closest.stats);
  const points: SurfacePoint[] = [closest.a, closest.b];
  for (const { triangle, position } of points) check(triangle + position[0] > -9, 'point');
  check(closest.distance === 0 && closest.lowerBound === 0, 'they touch');
  const within: ClearanceOptions = { maxPairs: 9 };
  const near: NearPairs = pelt.clearance(a, b, 0.01, within);
  check(near.count === 9 && near.stats.cutShort, 'clearance');
  const first: ClearanceOptions = { firstPair: true };
  check(pelt.clearance(a, b, 0.01, first).count === 1, 'firstPair');
  check(pelt.isWithin(a, b, 0), 'isWithin');
  check(pelt.containment(a, b) === 'none', 'containment');
  const deepest: Penetration | null = pelt.deepestVertex(a, b);
  if (deepest === null) throw new Error('deepestVertex');
  const { vertex, position, depth, closest: place, stats } = deepest;
  check(vertex >= 0 && depth > 0 && position.length + place.position.length === 6, 'deepest');
  useStats(stats);
}

function useMotion(pelt: Pelt, a: Pose, b: Pose): void {
  const steps: [Motion, Motion] = [
    { from: a, to: a },
    { from: b, to: b },
  ];
  const options: MovingOptions = { leaveOutStart: false, times: true, maxContacts: 9 };
  const found: MovingContacts = pelt.collideMoving(...steps, options);
  const { count, pairs, times, atStart, features, stats } = found;
  const lengths: number[] = [pairs.length, times.length, atStart.length, features.length];
  check(lengths.join() === [2 * count, count, count, 4 * count].join(), 'collideMoving');
  const { doublePairs, exactPairs }: MovingStats = stats;
  check(count === 9 && stats.cutShort && doublePairs >= exactPairs, 'moving stats');
  check(pelt.touchWhileMoving(...steps), 'touchWhileMoving');
  const first: MovingContact | null = pelt.firstContact(...steps);
  if (first === null) throw new Error('firstContact');
  check(first.atStart && first.time === 0 && first.triangleA + first.triangleB > 0, 'first');
  useStats(first.stats);
  const parts: Feature[] = [first.featureA, first.featureB];
  const kinds: number[] = [FeatureKind.corner, FeatureKind.edge, FeatureKind.face];
  check(parts.every(({ kind, number }) => kinds.includes(kind) && number < 3), 'features');
  const filter: SelfFilter = a.character.makeSelfFilter();
  const own: SelfMovingContacts = pelt.selfCollideMoving(steps[0], filter, options);
  const columns: MovingColumns = own;
  check(columns.times.length === own.count && own.leftOut.rings === 0, 'selfCollideMoving');
  check(pelt.selfTouchesWhileMoving(steps[0], filter) === own.count > 0, 'selfTouchesWhileMoving');
  filter.delete();
  const later: FirstContactOptions = { leaveOutStart: true };
  check(pelt.firstContact(...steps, later) === null, 'they stand still');
}

function useSearch(pelt: Pelt, a: Pose, b: Pose): void {
  const options: SearchOptions = { order: 'contacts', maxOpen: 100 };
  const search: CollisionSearch = pelt.makeSearch(a, b, options);
  check(search.verdict === 'unknown' && !search.isComplete && !search.isStale, 'search');
  check(search.run(500).cutShort, 'run');
  const { count, boxes, depths, pairCounts }: OpenRegions = search.openRegions();
  check(boxes.length + depths.length + pairCounts.length === 8 * count, 'openRegions');
  const numbers: number[] = [search.undecidedPairs, search.resolution, search.distanceBound];
  check(numbers.every((number) => number >= 0), 'enclosures');
  check(search.workDone >= search.longestStep, 'work');
  search.restart();
  search.run(Infinity);
  check(search.pairs().length === pelt.collide(a, b).pairs.length, 'pairs');
  search.delete();
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
  const arrays: MeshArrays = { name: 'statue', restPositions, triangles, weld: false, offsetCaps: 1 };
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
