/** Computes one frame: poses everything, queries all pairs, and collects what the page shows. */

import type { Pelt, Pose, QueryStats, Scene as EngineScene } from 'pelt';
import { collidingPairs } from './colliding_pairs';
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
  { frame, by, firstContact, boxLevel, spot }: Shot,
  spares: readonly Spare[] = [],
): FrameAnswer {
  stage.set(scene, frame, by);
  const { count, contacts, ignored, stats } = stage.collide(firstContact);
  if (boxLevel !== null) openNodes(pelt, stage.colliding, firstContact);
  const tally = new TouchTally(stage.characters);
  tally.addAll(frame, contacts);
  const instances = stage.poses.map((pose, i) => ({
    ...drawn(pose, spares[i]),
    ...boxesOf(stage.collidingOf(i), boxLevel),
  }));
  const touching = stage.sets.gather(contacts);
  return {
    instances: instances.map((instance, i) => ({ ...instance, touching: touching[i] })),
    glow: glowOf(stage.characters, instances, touching),
    spot: spot && answerSpot(stage, instances, contacts, spot),
    contacts: count,
    ignored,
    touches: tally.sorted(),
    work: workOf(stage.colliding, stats),
  };
}

export function answerStill(pelt: Pelt, stage: Stage, scene: EngineScene, shot: Shot): StillAnswer {
  const answer = answerFrame(pelt, stage, scene, shot);
  return { ...answer, seen: seenFromSides(stage.poses, answer.glow) };
}

function answerSpot(
  { characters, poses, sets }: Stage,
  instances: readonly Spare[],
  all: Uint32Array,
  spot: Spot,
): SpotAnswer {
  const contacts = contactsInSpot(characters, all, spot);
  const pairs = contacts.filter((_, i) => i % 4 >= 2);
  const glow = glowOf(characters, instances, sets.gather(contacts));
  return { pairs, glow, seen: seenFromSides(poses, glow) };
}

/** A crowd keeps no opened nodes: the same query of two poses at a time does. */
function openNodes(pelt: Pelt, poses: readonly Pose[], firstContact: boolean): void {
  for (const [a, b] of collidingPairs(poses)) pelt.collide(a, b, { firstContact });
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
