/** One frame: everything posed, every pair asked, all that the page draws and tells. */

import type { Pelt, Pose, QueryStats, Scene as EngineScene } from 'pelt';
import { collidingPairs } from './colliding_pairs';
import { glowOf } from './glow';
import type { FrameAnswer, PosedInstance, Shot, Spare, Spot, SpotAnswer, Work } from './protocol';
import { contactsInSpot } from './spots';
import type { Stage } from './stage';
import { TouchTally } from './touches';
import { wholeWorkOf } from './whole_work';

/** `spares` has arrays for the instances to be drawn with, where the page is done with some. */
export function answerFrame(
  pelt: Pelt,
  stage: Stage,
  scene: EngineScene,
  { frame, firstContact, boxLevel, spot }: Shot,
  spares: readonly Spare[] = [],
): FrameAnswer {
  stage.set(scene, frame);
  const { count, contacts, stats } = stage.collide(firstContact);
  if (boxLevel !== null) openNodes(pelt, stage.poses, firstContact);
  const tally = new TouchTally(stage.characters);
  tally.addAll(frame, contacts);
  const instances = stage.poses.map((pose, i) => drawn(pose, boxLevel, spares[i]));
  const touching = stage.sets.gather(contacts);
  return {
    instances: instances.map((instance, i) => ({ ...instance, touching: touching[i] })),
    glow: glowOf(stage.characters, instances, touching),
    spot: spot && answerSpot(stage, instances, contacts, spot),
    contacts: count,
    touches: tally.sorted(),
    work: workOf(stage.poses, stats),
  };
}

function answerSpot(
  { characters, sets }: Stage,
  instances: readonly Spare[],
  all: Uint32Array,
  spot: Spot,
): SpotAnswer {
  const contacts = contactsInSpot(characters, all, spot);
  const pairs = contacts.filter((_, i) => i % 4 >= 2);
  return { pairs, glow: glowOf(characters, instances, sets.gather(contacts)) };
}

/** A crowd keeps no opened nodes: the same query of two poses at a time does. */
function openNodes(pelt: Pelt, poses: readonly Pose[], firstContact: boolean): void {
  for (const [a, b] of collidingPairs(poses)) pelt.collide(a, b, { firstContact });
}

/** After the queries, which pose only what they need: the boxes tell what these have opened. */
function drawn(
  pose: Pose,
  boxLevel: number | null,
  spare: Spare | undefined,
): Omit<PosedInstance, 'touching'> {
  const deepest = pose.character.levelCount - 1;
  const boxes = boxLevel === null ? null : pose.nodeBoxes(Math.min(boxLevel, deepest));
  const length = 3 * pose.character.vertexCount;
  const fits = spare?.positions.length === length && spare.normals.length === length;
  return {
    positions: pose.posedVertices(fits ? spare.positions : undefined),
    normals: pose.normals(fits ? spare.normals : undefined),
    boxes: boxes?.boxes ?? new Float32Array(),
    boxStates: boxes?.states ?? new Uint8Array(),
  };
}

function workOf(poses: readonly Pose[], stats: QueryStats): Work {
  const whole = poses.map((pose) => wholeWorkOf(pose.character));
  return {
    refits: stats.refits,
    allRefits: whole.reduce((sum, { refits }) => sum + refits, 0),
    posedVertices: stats.posedVertices,
    allVertices: whole.reduce((sum, { posedVertices }) => sum + posedVertices, 0),
    trianglePairs: stats.trianglePairs,
  };
}
