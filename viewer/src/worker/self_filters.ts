/** Filters of the contacts of bodies with themselves. Each is made once, as the command makes it. */

import type { Character, Pelt, Scene as EngineScene, SelfFilter } from 'pelt';
import type { Body } from './bodies';
import type { By, SelfQuestion } from './protocol';

/** Pairs of triangles, [N][2], by models. */
type PairsOfModels = ReadonlyMap<string, Uint32Array>;

export class SelfFilters {
  private readonly numbers = new Map<Character, number>();
  private readonly made = new Map<string, SelfFilter>();
  private readonly atRest = new Map<string, Uint32Array>();
  /** The latest pairs that touch in nearly all frames, and the question that they answer. */
  private always: { key: string; filters: ReadonlyMap<string, SelfFilter> } | null = null;

  constructor(private readonly pelt: Pelt) {}

  /** Equal keys mean equal filters. */
  keyOf(scene: EngineScene, by: By, self: SelfQuestion | null): string {
    if (self?.always == null) return JSON.stringify(self);
    return `${alwaysKey(scene, by, self)}${this.areReady(scene, by, self) ? '' : ' not ready'}`;
  }

  /** Returns false while the contacts of all frames have to be found before. */
  areReady(scene: EngineScene, by: By, self: SelfQuestion | null): boolean {
    return self?.always == null || this.always?.key === alwaysKey(scene, by, self);
  }

  /** Precondition: `areReady`. */
  filterOf(character: Character, part: Body['part'], self: SelfQuestion): SelfFilter {
    const model = this.modelOf(character, part);
    if (self.always !== null) return this.always!.filters.get(model)!;
    const key = `${model} ${rulesKey(self)} ${self.dropsAtRest}`;
    const known = this.made.get(key);
    if (known) return known;
    const filter = this.make(character, part, self);
    this.made.set(key, filter);
    return filter;
  }

  /** A name for the character or its part. */
  modelOf(character: Character, part: Body['part']): string {
    const number = this.numbers.get(character) ?? this.numbers.size;
    this.numbers.set(character, number);
    return `${number} ${part}`;
  }

  /** Accepts the pairs that touch in nearly all frames. */
  knowAlways(
    scene: EngineScene,
    by: By,
    self: SelfQuestion,
    bodies: readonly Body[],
    pairs: PairsOfModels,
  ): void {
    const filters = new Map<string, SelfFilter>();
    for (const { instance, part } of bodies) {
      const character = scene.characters[scene.instances[instance].character];
      const model = this.modelOf(character, part);
      if (!filters.has(model)) {
        filters.set(model, this.make(character, part, self, pairs.get(model)));
      }
    }
    this.forgetAlways();
    this.always = { key: alwaysKey(scene, by, self), filters };
  }

  clear(): void {
    this.forgetAlways();
    for (const filter of this.made.values()) filter.delete();
    this.numbers.clear();
    this.made.clear();
    this.atRest.clear();
  }

  private forgetAlways(): void {
    for (const filter of this.always?.filters.values() ?? []) filter.delete();
    this.always = null;
  }

  private make(
    character: Character,
    part: Body['part'],
    self: SelfQuestion,
    always: Uint32Array = new Uint32Array(),
  ): SelfFilter {
    const { rings, dropsNearJoints: nearJoints } = self;
    const atRest = self.dropsAtRest ? this.pairsAtRest(character, part, self) : new Uint32Array();
    return character.makeSelfFilter({ rings, nearJoints, atRest, always }, part);
  }

  private pairsAtRest(character: Character, part: Body['part'], self: SelfQuestion): Uint32Array {
    const key = `${this.modelOf(character, part)} ${rulesKey(self)}`;
    const pairs = this.atRest.get(key) ?? this.findAtRest(character, part, self);
    this.atRest.set(key, pairs);
    return pairs;
  }

  /** In the rest pose of the file, and in the default pose of its nodes. */
  private findAtRest(character: Character, part: Body['part'], self: SelfQuestion): Uint32Array {
    const filter = this.make(character, part, { ...self, dropsAtRest: false });
    const pose = character.makePose(part);
    const found = new Map<number, [number, number]>();
    const collect = () => {
      const { pairs } = this.pelt.selfCollide(pose, filter);
      for (let i = 0; i < pairs.length; i += 2) {
        found.set(pairKey(character, pairs[i], pairs[i + 1]), [pairs[i], pairs[i + 1]]);
      }
    };
    collect();
    pose.setMorphWeights(character.morphWeights(null, 0));
    pose.setPalette(character.palette(null, 0));
    collect();
    pose.delete();
    filter.delete();
    return Uint32Array.from([...found.values()].flat());
  }
}

/** A number for a pair of triangles. */
export function pairKey({ triangleCount }: Character, a: number, b: number): number {
  return a * triangleCount + b;
}

function rulesKey({ rings, dropsNearJoints }: SelfQuestion): string {
  return `${rings} ${dropsNearJoints}`;
}

/** Everything that the contacts of all frames depend on. */
function alwaysKey(
  { instances, frameCount, fps }: EngineScene,
  by: By,
  self: SelfQuestion,
): string {
  return JSON.stringify({ instances, frameCount, fps, by, self: { ...self, isOnly: false } });
}
