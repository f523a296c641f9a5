/** One frame: everything posed, every pair asked, all that the page draws and tells. */

import type { Pelt, Pose, Scene as EngineScene } from 'pelt';
import { queryPairs, type PairContacts } from './pairs';
import type { Poses } from './poses';
import type { FrameAnswer, PosedInstance, Shot, Work } from './protocol';
import { TouchTally } from './touches';

export function answerFrame(pelt: Pelt, poses: Poses, scene: EngineScene, shot: Shot): FrameAnswer {
  const { frame, firstContact, boxLevel } = shot;
  poses.set(scene, frame);
  const pairs = queryPairs(poses.all, (a, b) => pelt.collide(a, b, { firstContact }));
  const touching = touchingTriangles(poses.all, pairs);
  return {
    instances: poses.all.map((pose, i) => drawn(pose, touching[i], boxLevel)),
    contacts: pairs.reduce((sum, { contacts }) => sum + contacts.count, 0),
    touches: tallied(poses.all, pairs),
    work: workOf(poses.all, pairs),
  };
}

function touchingTriangles(poses: readonly Pose[], pairs: readonly PairContacts[]): Uint32Array[] {
  const sets = poses.map(() => new Set<number>());
  for (const { a, b, contacts } of pairs) {
    contacts.pairs.forEach((triangle, i) => sets[i % 2 === 0 ? a : b].add(triangle));
  }
  return sets.map((set) => Uint32Array.from(set));
}

function tallied(poses: readonly Pose[], pairs: readonly PairContacts[]) {
  const tally = new TouchTally(poses.map((pose) => pose.character));
  for (const { a, b, contacts } of pairs) {
    for (let i = 0; i < contacts.pairs.length; i += 2) {
      tally.add(a, b, contacts.pairs[i], contacts.pairs[i + 1]);
    }
  }
  return tally.sorted();
}

/** After the queries, which pose only what they need: the boxes tell what these have opened. */
function drawn(pose: Pose, touching: Uint32Array, boxLevel: number | null): PosedInstance {
  const deepest = pose.character.levelCount - 1;
  const boxes = boxLevel === null ? null : pose.nodeBoxes(Math.min(boxLevel, deepest));
  return {
    positions: pose.posedVertices(),
    normals: pose.normals(),
    touching,
    boxes: boxes?.boxes ?? new Float32Array(),
    boxStates: boxes?.states ?? new Uint8Array(),
  };
}

function workOf(poses: readonly Pose[], pairs: readonly PairContacts[]): Work {
  const sum = (values: readonly number[]) => values.reduce((total, value) => total + value, 0);
  return {
    openedNodes: sum(poses.map((pose) => pose.openedNodeCount)),
    nodes: sum(poses.map((pose) => pose.character.nodeCount)),
    posedVertices: sum(pairs.map(({ contacts }) => contacts.stats.posedVertices)),
    vertices: sum(poses.map((pose) => pose.character.vertexCount)),
    trianglePairs: sum(pairs.map(({ contacts }) => contacts.stats.trianglePairs)),
  };
}
