/** Finds what touches between two frames and in neither of them, like `pelt check --between`. */

import type { ContactHash, Pelt, Scene as EngineScene } from 'pelt';
import type { Step } from './protocol';
import type { MovingSceneContacts, SceneContacts, SceneCrowd } from './scene_crowd';

export class Steps {
  private readonly hash: ContactHash;
  /** The frame in which the next step begins. */
  private from: number | null = null;

  constructor(
    pelt: Pelt,
    private readonly scene: EngineScene,
    private readonly crowd: SceneCrowd,
  ) {
    this.hash = pelt.makeContactHash();
  }

  /** Call before the crowd is set to the next frame. */
  begin(): void {
    this.crowd.beginStep();
  }

  /**
   * Call once the crowd is set to a frame, which has the contacts `found`. Returns null if nothing
   * touches only in the step that ends in it.
   */
  end(frame: number, found: SceneContacts): Step | null {
    const { from } = this;
    this.from = frame;
    if (from === null) return null;
    const moving = this.crowd.collideMoving();
    const rows = rowsOnlyIn(moving.ofBodies, found.ofBodies);
    if (rows.length === 0) return null;
    this.hash.addCrowd(from, gather(moving.ofBodies, rows));
    return { frame: from, contacts: rows.length, first: this.firstOf(moving, rows, from, frame) };
  }

  get hashValue(): string {
    return this.hash.value;
  }

  delete(): void {
    this.hash.delete();
  }

  /** The row with the least time; of equal ones, the first. */
  private firstOf(
    { contacts, ofBodies, times }: MovingSceneContacts,
    rows: readonly number[],
    from: number,
    to: number,
  ): Step['first'] {
    const row = rows.reduce((one, other) => (times[other] < times[one] ? other : one));
    const share = times[row];
    const [a, b, triangleA, triangleB] = contacts.subarray(4 * row, 4 * row + 4);
    const seconds = (from + (to - from) * share) / this.scene.fps;
    const isOfSelf = ofBodies[4 * row] === ofBodies[4 * row + 1];
    return { to, share, seconds, a, b, triangles: [triangleA, triangleB], isOfSelf };
  }
}

/** Returns the rows of `all` that `some` does not have. Both have rows of four numbers, ascending. */
function rowsOnlyIn(all: Uint32Array, some: Uint32Array): number[] {
  const only: number[] = [];
  let next = 0;
  for (let at = 0; at < all.length; at += 4) {
    while (next < some.length && compare(some, next, all, at) < 0) next += 4;
    if (next === some.length || compare(some, next, all, at) > 0) only.push(at / 4);
  }
  return only;
}

/** Compares two rows. */
function compare(one: Uint32Array, at: number, other: Uint32Array, otherAt: number): number {
  for (let i = 0; i < 4; ++i) {
    const difference = one[at + i] - other[otherAt + i];
    if (difference !== 0) return difference;
  }
  return 0;
}

function gather(all: Uint32Array, rows: readonly number[]): Uint32Array {
  const gathered = new Uint32Array(4 * rows.length);
  rows.forEach((row, i) => gathered.set(all.subarray(4 * row, 4 * row + 4), 4 * i));
  return gathered;
}
