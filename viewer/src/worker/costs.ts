/** What a frame's query costs, and what refitting everything first would have cost. */

import type { Contacts, Pelt, Pose, Scene as EngineScene } from 'pelt';
import { queryPairs } from './pairs';
import type { Poses } from './poses';
import type { Cost, Costs, Shot } from './protocol';

/** Clocks of browsers tick in steps of up to a tenth of a millisecond. */
const LEAST_MILLISECONDS = 2;

type Query = (a: Pose, b: Pose) => Contacts;

export function measureCosts(pelt: Pelt, poses: Poses, scene: EngineScene, shot: Shot): Costs {
  const options = { firstContact: shot.firstContact };
  const cost = (query: Query) => measure(poses, scene, shot.frame, query);
  const onDemand = cost((a, b) => pelt.collide(a, b, options));
  const eager = cost((a, b) => pelt.collideEagerly(a, b, options));
  return { onDemand, eager: oncePerInstance(eager, poses.all.length) };
}

/** Repeats the query in fresh poses until a clock can tell how long it takes. */
function measure(poses: Poses, scene: EngineScene, frame: number, query: Query): Cost {
  let [milliseconds, rounds, posedVertices, refits] = [0, 0, 0, 0];
  do {
    poses.set(scene, frame);
    const begin = performance.now();
    const pairs = queryPairs(poses.all, query);
    milliseconds += performance.now() - begin;
    ++rounds;
    posedVertices = pairs.reduce((sum, { contacts }) => sum + contacts.stats.posedVertices, 0);
    refits = pairs.reduce((sum, { contacts }) => sum + contacts.stats.refits, 0);
  } while (milliseconds < LEAST_MILLISECONDS);
  return { microseconds: (1000 * milliseconds) / rounds, posedVertices, refits };
}

/** `collideEagerly` refits an instance for each other one; an engine that does so would do it once. */
function oncePerInstance(cost: Cost, instances: number): Cost {
  const share = 1 / Math.max(1, instances - 1);
  return {
    microseconds: cost.microseconds * share,
    posedVertices: cost.posedVertices * share,
    refits: cost.refits * share,
  };
}
