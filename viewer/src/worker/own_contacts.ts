/**
 * Finds the contacts of one character with itself: of each of its bodies, and of every two parts; and
 * makes the filters of these contacts, each once, as the command makes it.
 */

import type { Character, Crowd, Pelt, Scene as EngineScene, SelfFilter } from 'pelt';
import { partsOf, type Body } from './bodies';
import type { By, SelfQuestion } from './protocol';

/** Pairs of triangles, [N][2]. */
export type Pairs = Uint32Array;

/** Applies the filters to the bodies of one character, which have these numbers in the crowd. */
export function setFilters(
  crowd: Crowd,
  character: Character,
  bodies: readonly { number: number; part: Body['part'] }[],
  filters: SelfFilters,
  question: SelfQuestion,
): void {
  for (const { number, part } of bodies) {
    crowd.setSelfFilter(number, filters.filterOf(character, part, question));
  }
  const parts = bodies.filter(({ part }) => part !== null).map(({ number }) => number);
  if (parts.length > 0) {
    crowd.filterParts(parts, filters.filterOf(character, null, question, 'part'));
  }
}

export class OwnContacts {
  private readonly crowd: Crowd;
  private readonly count: number;

  /** `parts`: null for the whole character. */
  constructor(
    pelt: Pelt,
    readonly character: Character,
    parts: readonly Body['part'][],
    filters: SelfFilters,
    question: SelfQuestion,
  ) {
    this.crowd = pelt.makeCrowd();
    this.count = parts.length;
    const bodies = parts.map((part) => ({ number: this.crowd.add(character, part), part }));
    setFilters(this.crowd, character, bodies, filters, question);
  }

  /** Returns the pairs of triangles in ascending order. */
  find(palette: Float32Array, weights: Float32Array): Pairs {
    for (let body = 0; body < this.count; ++body) {
      this.crowd.setPalette(body, palette);
      this.crowd.setMorphWeights(body, weights);
    }
    return ascending(this.crowd.collide().contacts, this.character.triangleCount);
  }

  delete(): void {
    this.crowd.delete();
  }
}

/** A crowd sorts contacts by bodies first. */
function ascending(contacts: Uint32Array, triangleCount: number): Pairs {
  const keys = new Float64Array(contacts.length / 4);
  for (let i = 0; i < keys.length; ++i) {
    keys[i] = contacts[4 * i + 2] * triangleCount + contacts[4 * i + 3];
  }
  keys.sort();
  const pairs = new Uint32Array(2 * keys.length);
  keys.forEach((key, i) => {
    pairs[2 * i] = Math.floor(key / triangleCount);
    pairs[2 * i + 1] = key % triangleCount;
  });
  return pairs;
}

export class SelfFilters {
  private readonly numbers = new Map<Character, number>();
  private readonly made = new Map<string, SelfFilter>();
  private readonly atRest = new Map<string, Pairs>();
  /** The latest pairs that touch in nearly all frames, and the question that they answer. */
  private always: { key: string; pairs: ReadonlyMap<Character, Pairs> } | null = null;
  private readonly madeOfAlways = new Map<string, SelfFilter>();

  constructor(private readonly pelt: Pelt) {}

  /** Equal keys mean equal filters. */
  keyOf(scene: EngineScene, by: By, self: SelfQuestion | null): string {
    if (self?.always == null) return JSON.stringify(self);
    const key = JSON.stringify([alwaysKey(scene, by, self), self.isOnly]);
    return `${key}${this.areReady(scene, by, self) ? '' : ' not ready'}`;
  }

  /** Returns false while the contacts of all frames have to be found before. */
  areReady(scene: EngineScene, by: By, self: SelfQuestion | null): boolean {
    return self?.always == null || this.always?.key === alwaysKey(scene, by, self);
  }

  /**
   * Returns the filter of a character or part. With `by` part, the filter of a whole character serves
   * contacts of its parts. Precondition: `areReady`.
   */
  filterOf(
    character: Character,
    part: Body['part'],
    self: SelfQuestion,
    by: By = part === null ? 'instance' : 'part',
  ): SelfFilter {
    const made = self.always === null ? this.made : this.madeOfAlways;
    const key = `${this.rulesKey(character, by, self)} ${self.dropsAtRest} ${part}`;
    const filter = made.get(key) ?? this.make(character, part, by, self);
    made.set(key, filter);
    return filter;
  }

  /** Accepts the pairs that touch in nearly all frames. */
  knowAlways(
    scene: EngineScene,
    by: By,
    self: SelfQuestion,
    pairs: ReadonlyMap<Character, Pairs>,
  ): void {
    this.forgetAlways();
    this.always = { key: alwaysKey(scene, by, self), pairs };
  }

  clear(): void {
    this.forgetAlways();
    for (const filter of this.made.values()) filter.delete();
    this.numbers.clear();
    this.made.clear();
    this.atRest.clear();
  }

  private forgetAlways(): void {
    for (const filter of this.madeOfAlways.values()) filter.delete();
    this.madeOfAlways.clear();
    this.always = null;
  }

  private make(character: Character, part: Body['part'], by: By, self: SelfQuestion): SelfFilter {
    const { rings, dropsNearJoints: nearJoints } = self;
    const atRest = self.dropsAtRest ? this.pairsAtRest(character, by, self) : new Uint32Array();
    const always = (self.always !== null && this.always?.pairs.get(character)) || new Uint32Array();
    return character.makeSelfFilter({ rings, nearJoints, atRest, always }, part);
  }

  private pairsAtRest(character: Character, by: By, self: SelfQuestion): Pairs {
    const key = this.rulesKey(character, by, self);
    const pairs = this.atRest.get(key) ?? this.findAtRest(character, by, self);
    this.atRest.set(key, pairs);
    return pairs;
  }

  /** In the rest pose of the file, and in the default pose of its nodes. */
  private findAtRest(character: Character, by: By, self: SelfQuestion): Pairs {
    const question = { ...self, dropsAtRest: false, always: null };
    const own = new OwnContacts(this.pelt, character, partsOf(character, by), this, question);
    const noWeights = new Float32Array(character.morphTargetNames.length);
    const inFile = own.find(identities(character), noWeights);
    const ofNodes = own.find(character.palette(null, 0), character.morphWeights(null, 0));
    own.delete();
    return Uint32Array.from([...inFile, ...ofNodes]);
  }

  private rulesKey(character: Character, by: By, { rings, dropsNearJoints }: SelfQuestion): string {
    const number = this.numbers.get(character) ?? this.numbers.size;
    this.numbers.set(character, number);
    return `${number} ${by} ${rings} ${dropsNearJoints}`;
  }
}

/** The palette of the rest pose. */
function identities({ jointCount }: Character): Float32Array {
  return Float32Array.from({ length: 16 * jointCount }, (_, i) => Number((i % 16) % 5 === 0));
}

/** Everything that the contacts of all frames depend on. */
function alwaysKey(
  { instances, frameCount, fps }: EngineScene,
  by: By,
  self: SelfQuestion,
): string {
  return JSON.stringify({ instances, frameCount, fps, by, self: { ...self, isOnly: false } });
}
