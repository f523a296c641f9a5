/** Uses all queries of poses; see consumer.ts. */

import {
  type Bounds,
  type BoxRegion,
  type Capsule,
  type CastOptions,
  type ClearanceOptions,
  type ClosestPoint,
  type ClosestPointOptions,
  type ContactCurve,
  type ContactGeometry,
  type ContactTally,
  ContactKind,
  type ContactPatch,
  type ConvexPolyhedron,
  type Contacts,
  type CollideOptions,
  type CollisionSearch,
  type Distance,
  type DistanceOptions,
  type Face,
  type Feature,
  FeatureKind,
  type FirstContactOptions,
  type Frustum,
  type HalfSpace,
  type LeftOut,
  type Motion,
  type MovingColumns,
  type MovingContact,
  type MovingContacts,
  type MovingOptions,
  type MovingStats,
  type NearPairs,
  type NodeBoxes,
  NodeState,
  type OpenRegions,
  type OrientedBox,
  type Pelt,
  type Penetration,
  type Pose,
  type QueryStats,
  type RayHit,
  type Region,
  type SearchOptions,
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

export function check(holds: boolean, what: string): void {
  if (!holds) throw new Error(what);
}

export function usePose(pose: Pose): void {
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

export function useStats(stats: QueryStats): void {
  const { nodePairs, refits, posedVertices, trianglePairs, displacements, clampedOffsets } = stats;
  check(nodePairs + refits + posedVertices + trianglePairs + displacements > 0, 'stats');
  check(stats.cutShort === false && clampedOffsets === 0, 'cutShort');
}

export function useContacts(pelt: Pelt, a: Pose, b: Pose): void {
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

export function useSelf(pelt: Pelt, pose: Pose): void {
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

export function useDistance(pelt: Pelt, a: Pose, b: Pose): void {
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

export function useMotion(pelt: Pelt, a: Pose, b: Pose): void {
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
  check(
    parts.every(({ kind, number }) => kinds.includes(kind) && number < 3),
    'features',
  );
  const filter: SelfFilter = a.character.makeSelfFilter();
  const own: SelfMovingContacts = pelt.selfCollideMoving(steps[0], filter, options);
  const columns: MovingColumns = own;
  check(columns.times.length === own.count && own.leftOut.rings === 0, 'selfCollideMoving');
  check(pelt.selfTouchesWhileMoving(steps[0], filter) === own.count > 0, 'selfTouchesWhileMoving');
  filter.delete();
  const later: FirstContactOptions = { leaveOutStart: true };
  check(pelt.firstContact(...steps, later) === null, 'they stand still');
}

export function useSearch(pelt: Pelt, a: Pose, b: Pose): void {
  const options: SearchOptions = { order: 'contacts', maxOpen: 100 };
  const search: CollisionSearch = pelt.makeSearch(a, b, options);
  check(search.verdict === 'unknown' && !search.isComplete && !search.isStale, 'search');
  check(search.run(500).cutShort, 'run');
  const { count, boxes, depths, pairCounts }: OpenRegions = search.openRegions();
  check(boxes.length + depths.length + pairCounts.length === 8 * count, 'openRegions');
  const numbers: number[] = [search.undecidedPairs, search.resolution, search.distanceBound];
  check(
    numbers.every((number) => number >= 0),
    'enclosures',
  );
  check(search.workDone >= search.longestStep, 'work');
  search.restart();
  search.run(Infinity);
  check(search.pairs().length === pelt.collide(a, b).pairs.length, 'pairs');
  search.delete();
}
