/**
 * Measures the cost of a frame's query, and of refitting everything first. Measures in steps, so
 * that a requested frame need not wait.
 */

import type { Character, Pelt, Pose, Scene as EngineScene } from 'pelt';
import { collidingPairs } from './body_pairs';
import type { SelfFilters } from './own_contacts';
import type { Cost, Costs, Questions, Shot } from './protocol';
import { limit } from './scene_crowd';
import { Stage } from './stage';

/** Clocks of browsers tick in steps of up to a tenth of a millisecond. */
const LEAST_MILLISECONDS = 2;

const SLICE_MILLISECONDS = 4;

type Steps<Result> = Generator<undefined, Result>;

export class CostMeter {
  private readonly stage: Stage;
  private readonly watch = new Stopwatch();
  private id = -1;
  private steps: Steps<Costs> | null = null;

  constructor(
    private readonly pelt: Pelt,
    filters: SelfFilters,
  ) {
    this.stage = new Stage(pelt, filters);
  }

  /** Works for a few milliseconds. Returns null if there is more to do. */
  advance({ id, shot }: Questions['measure'], scene: EngineScene): Costs | null {
    if (id !== this.id || !this.steps) this.steps = this.measure(scene, shot);
    this.id = id;
    const end = performance.now() + SLICE_MILLISECONDS;
    this.watch.goOn();
    let step = this.steps.next();
    while (!step.done && performance.now() < end) step = this.steps.next();
    this.watch.pause();
    return step.done ? step.value : null;
  }

  clear(): void {
    this.steps = null;
    this.stage.clear();
  }

  private *measure(scene: EngineScene, shot: Shot): Steps<Costs> {
    const { frame, by, self } = shot;
    this.stage.set(scene, frame, by, self);
    yield;
    const onDemand = yield* this.cost(() => this.askOnDemand(shot));
    const eager = yield* this.cost(() => this.askEagerly(shot));
    return { onDemand, eager, ...this.countNodes(shot) };
  }

  /** Doubles the number of rounds until the clock can measure their time. */
  private *cost(round: () => Steps<number>): Steps<Cost> {
    for (let rounds = 1; ; rounds *= 2) {
      let trianglePairs = 0;
      this.watch.start();
      for (let i = 0; i < rounds; ++i) trianglePairs = yield* round();
      const { milliseconds } = this.watch;
      if (milliseconds < LEAST_MILLISECONDS) continue;
      return { microseconds: (1000 * milliseconds) / rounds, trianglePairs };
    }
  }

  private *askOnDemand(shot: Shot): Steps<number> {
    const { stats } = this.stage.collide(shot);
    yield;
    return stats.trianglePairs;
  }

  /** Everything is refitted once, and then compared with all those that it is near. */
  private *askEagerly({ maxContacts, self }: Shot): Steps<number> {
    const poses = this.stage.colliding;
    for (const pose of poses) {
      pose.openAll();
      yield;
    }
    let trianglePairs = 0;
    for (const [a, b] of self?.isOnly ? [] : collidingPairs(poses)) {
      trianglePairs += this.pelt.collideEagerly(a, b, limit(maxContacts)).stats.trianglePairs;
      yield;
    }
    trianglePairs += this.stage.collideSelf(maxContacts);
    yield;
    return trianglePairs;
  }

  private countNodes({ maxContacts, self }: Shot): { openedNodes: number; nodes: number } {
    const poses = this.stage.colliding;
    const pairs = self?.isOnly ? [] : collidingPairs(poses);
    for (const [a, b] of pairs) this.pelt.collide(a, b, limit(maxContacts));
    this.stage.collideSelf(maxContacts);
    const sum = (count: (pose: Pose) => number) =>
      poses.reduce((total, pose) => total + count(pose), 0);
    return {
      openedNodes: sum((pose) => pose.openedNodeCount),
      nodes: sum((pose) => pose.nodeCount),
    };
  }
}

/** Tells how long something takes that is done bit by bit, with other things in between. */
class Stopwatch {
  private before = 0;
  private since = 0;

  start(): void {
    this.before = 0;
    this.since = performance.now();
  }

  pause(): void {
    this.before = this.milliseconds;
  }

  goOn(): void {
    this.since = performance.now();
  }

  get milliseconds(): number {
    return this.before + performance.now() - this.since;
  }
}

/** Work of refitting everything for an instance of a character or a part; the same in every pose. */
export interface WholeWork {
  refits: number;
  posedVertices: number;
}

const known = new WeakMap<Character, Map<Pose['part'], WholeWork>>();

export function wholeWorkOf({ character, part }: Pose): WholeWork {
  const ofParts = known.get(character) ?? new Map();
  known.set(character, ofParts);
  const work = ofParts.get(part) ?? refitOnce(character, part);
  ofParts.set(part, work);
  return work;
}

function refitOnce(character: Character, part: Pose['part']): WholeWork {
  const pose = character.makePose(part);
  const { refits, posedVertices } = pose.openAll();
  pose.delete();
  return { refits, posedVertices };
}
