/** Computes one frame: poses everything, queries all pairs, and collects what the page shows. */

import type { Pelt, Pose, QueryStats, Scene as EngineScene } from 'pelt';
import { closestPointsOf } from './closest_points';
import { collidingPairs, pairsWithin } from './colliding_pairs';
import { glowOf } from './glow';
import type {
  FrameAnswer,
  PosedInstance,
  Shot,
  Spare,
  Spot,
  SpotAnswer,
  StillAnswer,
  Work,
} from './protocol';
import { limit, split, type SplitContacts } from './scene_crowd';
import { contactsInSpot } from './spots';
import type { Stage } from './stage';
import { TouchTally } from './touches';
import { seenFromSides } from './visibility';
import { wholeWorkOf } from './whole_work';

/** `spares` has arrays for the instances to be drawn with, where the page is done with some. */
export function answerFrame(
  pelt: Pelt,
  stage: Stage,
  scene: EngineScene,
  shot: Shot,
  spares: readonly Spare[] = [],
): FrameAnswer {
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
function openNodes(pelt: Pelt, stage: Stage, { maxContacts, clearance, self }: Shot): void {
  const poses = stage.colliding;
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
