/**
 * Finds the pairs of triangles that touch in nearly all frames, one frame at a time, for the filter
 * that drops them.
 */

import type { Character, Pelt, Scene as EngineScene } from 'pelt';
import type { By, SelfQuestion } from './protocol';
import { SceneCrowd } from './scene_crowd';
import { pairKey, type SelfFilters } from './self_filters';

/** The poses of a character or part so far, and how many of them have each pair. */
interface Tally {
  character: Character;
  poses: number;
  counts: Map<number, number>;
}

export class AlwaysSearch {
  private readonly crowd: SceneCrowd;
  private readonly tallies = new Map<string, Tally>();

  constructor(
    pelt: Pelt,
    private readonly filters: SelfFilters,
    private readonly scene: EngineScene,
    private readonly by: By,
    private readonly self: SelfQuestion,
  ) {
    const others = { ...self, isOnly: true, always: null };
    this.crowd = new SceneCrowd(pelt, scene, by, { question: others, filters }, []);
  }

  addFrame(frame: number): void {
    this.crowd.set(this.scene, frame);
    const { ofBodies } = this.crowd.collide(false);
    const tallies = this.crowd.bodies.map((_, body) => this.tallyOf(body));
    for (const tally of tallies) ++tally.poses;
    for (let i = 0; i < ofBodies.length; i += 4) {
      const { character, counts } = tallies[ofBodies[i]];
      const key = pairKey(character, ofBodies[i + 2], ofBodies[i + 3]);
      counts.set(key, (counts.get(key) ?? 0) + 1);
    }
  }

  /** Makes the filters. */
  end(): void {
    const share = this.self.always!;
    const pairs = new Map(
      [...this.tallies].map(([model, tally]) => [model, pairsIn(tally, share)] as const),
    );
    this.filters.knowAlways(this.scene, this.by, this.self, this.crowd.bodies, pairs);
  }

  delete(): void {
    this.crowd.delete();
  }

  private tallyOf(body: number): Tally {
    const { instance, part } = this.crowd.bodies[body];
    const character = this.crowd.characters[instance];
    const model = this.filters.modelOf(character, part);
    const tally = this.tallies.get(model) ?? { character, poses: 0, counts: new Map() };
    this.tallies.set(model, tally);
    return tally;
  }
}

/** A quotient is rounded like the share: 55 of 100 poses are a share of 0.55. */
function pairsIn({ character: { triangleCount }, poses, counts }: Tally, share: number) {
  const often = [...counts].filter(([, count]) => count / poses >= share);
  return Uint32Array.from(
    often.flatMap(([key]) => [Math.floor(key / triangleCount), key % triangleCount]),
  );
}
