/** Computes one frame: poses everything, queries all pairs, and collects what the page shows. */

import type { Pelt, Pose, QueryStats, Scene as EngineScene } from 'pelt';
import { collidingPairs, findWithBudget, pairsWithin } from './body_pairs';
import { closestPointsOf, contactsInSpot, seenFromSides } from './close_ups';
import { wholeWorkOf } from './costs';
import { glowOf } from './glow';
import type {
  FrameAnswer,
  Moment,
  PosedInstance,
  Shot,
  Spare,
  Spot,
  SpotAnswer,
  StillAnswer,
  Work,
} from './protocol';
import { limit, split, type SplitContacts } from './scene_crowd';
import type { Stage } from './stage';
import { NO_WORK, NOTHING_LEFT_OUT } from './sums';
import { TouchTally } from './touches';

/** `spares` has arrays for the instances to be drawn with, where the page is done with some. */
export function answerFrame(
  pelt: Pelt,
  stage: Stage,
  scene: EngineScene,
  shot: Shot,
  spares: readonly Spare[] = [],
): FrameAnswer {
  if (shot.moment) return answerMoment(stage, scene, shot, shot.moment, spares);
  const { frame, by, self, boxLevel, clearance, spot } = shot;
  stage.set(scene, frame, by, self);
  const found = stage.collide(shot);
  if (boxLevel !== null) openNodes(pelt, stage, shot);
  const tally = new TouchTally(stage.characters);
  tally.addAll(frame, found.contacts);
  const instances = stage.poses.map((pose, i) => ({
    ...drawn(pose, spares[i]),
    ...boxesOf(stage.collidingOf(i), boxLevel),
  }));
  const { ofSelf, ofPairs } = split(found);
  const { sets } = stage;
  return {
    instances,
    glow: glowOf(stage.characters, instances, sets.gather(ofSelf), sets.gather(ofPairs)),
    spot: spot && answerSpot(stage, instances, { ofSelf, ofPairs }, spot),
    contacts: found.count,
    selfContacts: ofSelf.length / 4,
    leftOut: found.leftOut,
    isPreliminary: !stage.isReady,
    ignored: found.ignored,
    undecided: found.undecided,
    touches: tally.sorted(),
    // After the boxes, which show what the query itself has opened.
    closest: clearance === null ? [] : closestPointsOf(pelt, stage, found, clearance),
    work: workOf(stage.colliding, found.stats),
  };
}

export function answerStill(pelt: Pelt, stage: Stage, scene: EngineScene, shot: Shot): StillAnswer {
  const answer = answerFrame(pelt, stage, scene, shot);
  return { ...answer, seen: seenFromSides(stage.poses, answer.glow) };
}

/** The contact of a time between two frames. Vertices are on straight lines between these. */
function answerMoment(
  stage: Stage,
  scene: EngineScene,
  { frame, by, self }: Shot,
  { to, share, a, b, triangles, isOfSelf }: Moment,
  spares: readonly Spare[],
): FrameAnswer {
  stage.set(scene, to, by, self);
  const later = stage.poses.map((pose) => drawn(pose, undefined));
  stage.set(scene, frame, by, self);
  const instances = stage.poses.map((pose, i) => ({
    ...between(drawn(pose, spares[i]), later[i], share),
    ...boxesOf([], null),
  }));
  const contact = Uint32Array.of(a, b, ...triangles);
  const [ofSelf, ofPairs] = isOfSelf ? [contact, NO_CONTACTS] : [NO_CONTACTS, contact];
  const { characters, poses, sets } = stage;
  const glow = glowOf(characters, instances, sets.gather(ofSelf), sets.gather(ofPairs));
  const tally = new TouchTally(characters);
  tally.addAll(frame, contact);
  return {
    instances,
    glow,
    spot: { pairs: Uint32Array.from(triangles), glow, seen: seenFromSides(poses, glow) },
    contacts: 1,
    selfContacts: Number(isOfSelf),
    leftOut: NOTHING_LEFT_OUT,
    isPreliminary: false,
    ignored: 0,
    undecided: 0,
    touches: tally.sorted(),
    closest: [],
    work: workOf(stage.colliding, NO_WORK),
  };
}

const NO_CONTACTS = new Uint32Array();

/** Replaces positions and normals by those after a share of the way to `later`. */
function between(drawn: Spare, later: Spare, share: number): Spare {
  for (const values of ['positions', 'normals'] as const) {
    const [from, to] = [drawn[values], later[values]];
    for (let i = 0; i < from.length; ++i) from[i] += share * (to[i] - from[i]);
  }
  return drawn;
}

function answerSpot(
  { characters, poses, sets }: Stage,
  instances: readonly Spare[],
  { ofSelf, ofPairs }: SplitContacts,
  spot: Spot,
): SpotAnswer {
  const [own, others] = [ofSelf, ofPairs].map((all) => contactsInSpot(characters, all, spot));
  const found = own.length > 0 ? own : others; // a spot is of one kind
  const pairs = found.filter((_, i) => i % 4 >= 2);
  const glow = glowOf(characters, instances, sets.gather(own), sets.gather(others));
  return { pairs, glow, seen: seenFromSides(poses, glow) };
}

/** A crowd keeps no opened nodes: the same query of two poses at a time does. */
function openNodes(pelt: Pelt, stage: Stage, shot: Shot): void {
  const { maxContacts, clearance, budget, self } = shot;
  const poses = stage.colliding;
  if (budget !== null) {
    findWithBudget(pelt, poses, budget);
    return;
  }
  if (clearance !== null) {
    const maxPairs = maxContacts ?? Infinity;
    for (const [a, b] of pairsWithin(poses, clearance))
      pelt.clearance(poses[a], poses[b], clearance, { maxPairs });
    return;
  }
  const pairs = self?.isOnly ? [] : collidingPairs(poses);
  for (const [a, b] of pairs) pelt.collide(a, b, limit(maxContacts));
  stage.collideSelf(maxContacts);
}

function drawn(pose: Pose, spare: Spare | undefined): Spare {
  const length = 3 * pose.character.vertexCount;
  const fits = spare?.positions.length === length && spare.normals.length === length;
  return {
    positions: pose.posedVertices(fits ? spare.positions : undefined),
    normals: pose.normals(fits ? spare.normals : undefined),
  };
}

/** Call after the queries: the boxes show which nodes they have opened. */
function boxesOf(
  poses: readonly Pose[],
  level: number | null,
): Pick<PosedInstance, 'boxes' | 'boxStates'> {
  const found = poses.flatMap((pose) => {
    const deepest = pose.character.levelCount - 1;
    return level === null ? [] : [pose.nodeBoxes(Math.min(level, deepest))];
  });
  const count = found.reduce((sum, one) => sum + one.count, 0);
  const joined = { boxes: new Float32Array(6 * count), boxStates: new Uint8Array(count) };
  let next = 0;
  for (const { count, boxes, states } of found) {
    joined.boxes.set(boxes, 6 * next);
    joined.boxStates.set(states, next);
    next += count;
  }
  return joined;
}

function workOf(poses: readonly Pose[], stats: QueryStats): Work {
  const whole = poses.map((pose) => wholeWorkOf(pose));
  return {
    refits: stats.refits,
    allRefits: whole.reduce((sum, { refits }) => sum + refits, 0),
    posedVertices: stats.posedVertices,
    allVertices: whole.reduce((sum, { posedVertices }) => sum + posedVertices, 0),
    trianglePairs: stats.trianglePairs,
  };
}
