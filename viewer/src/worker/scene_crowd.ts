/**
 * The colliding bodies of a scene as a crowd. The command uses the same query, with the same work
 * and the same answer.
 */

import type {
  Character,
  CollideOptions,
  Crowd,
  CrowdContacts,
  CrowdMovingContacts,
  NamePair,
  Pelt,
  Pose,
  Scene as EngineScene,
} from 'pelt';
import { bodiesOf, type Body } from './bodies';
import { BodyPoses, findNear, findWithBudget } from './body_pairs';
import { setFilters, type SelfFilters } from './own_contacts';
import type { By, ContactQuestion, SelfQuestion } from './protocol';
import { NOTHING_LEFT_OUT, sumOfLeftOut, sumOfStats } from './sums';

export interface SceneContacts extends CrowdContacts {
  /** Like `contacts`, with numbers of bodies instead of instances, for the hash. */
  ofBodies: Uint32Array;
  /** Pairs of triangles that the budget has left undecided. */
  undecided: number;
}

/** Contacts of a step that do not touch at its start. */
export interface MovingSceneContacts extends Pick<SceneContacts, 'contacts' | 'ofBodies'> {
  /** Of each contact: the share of the step that has passed when it first touches. */
  times: Float32Array;
}

/** How bodies are tested against themselves, and where the filters are. */
export interface SelfTest {
  question: SelfQuestion | null;
  filters: SelfFilters;
}

export class SceneCrowd {
  /** Palettes of the current frame, by instance. */
  readonly palettes: Float32Array[];
  readonly morphWeights: Float32Array[];
  /** Character of each instance. */
  readonly characters: Character[];
  readonly bodies: Body[];
  /** Whether the filters of contacts of bodies with themselves are ready. If not, none is found. */
  readonly isReady: boolean;
  /** One with all bodies, or one for each body if no two bodies are tested. */
  private readonly crowds: Crowd[];
  /** For queries of two bodies; created on first use. */
  private poses: BodyPoses | null = null;
  private readonly ignored: string;
  private readonly selfKey: string;

  constructor(
    private readonly pelt: Pelt,
    scene: EngineScene,
    private readonly by: By,
    { question, filters }: SelfTest,
  ) {
    const { ignore } = scene;
    this.characters = scene.instances.map(({ character }) => scene.characters[character]);
    this.palettes = this.characters.map(({ jointCount }) => new Float32Array(16 * jointCount));
    this.morphWeights = this.characters.map((c) => new Float32Array(c.morphTargetNames.length));
    this.bodies = bodiesOf(scene, by);
    this.crowds = question?.isOnly
      ? this.bodies.map((body) => this.makeCrowd([body], ignore))
      : [this.makeCrowd(this.bodies, ignore)];
    this.ignored = JSON.stringify(ignore);
    this.selfKey = filters.keyOf(scene, by, question);
    this.isReady = filters.areReady(scene, by, question);
    if (question && this.isReady) this.filter(question, filters);
  }

  /** Whether it can be reused for that scene: the same characters, wherever they are placed. */
  fits(scene: EngineScene, by: By, { question, filters }: SelfTest): boolean {
    const { instances, characters, ignore } = scene;
    return (
      by === this.by &&
      instances.length === this.characters.length &&
      instances.every(({ character }, i) => characters[character] === this.characters[i]) &&
      JSON.stringify(ignore) === this.ignored &&
      filters.keyOf(scene, by, question) === this.selfKey
    );
  }

  set(scene: EngineScene, frame: number): void {
    this.palettes.forEach((palette, i) => scene.palette(i, frame, palette));
    this.morphWeights.forEach((weights, i) => scene.morphWeights(i, frame, weights));
    this.bodies.forEach(({ instance }, body) => {
      const [crowd, member] = this.placeOf(body);
      crowd.setPalette(member, this.palettes[instance]);
      crowd.setMorphWeights(member, this.morphWeights[instance]);
    });
  }

  collide(question: ContactQuestion): SceneContacts {
    const found = this.find(question);
    return {
      undecided: 0,
      ...found,
      contacts: this.ofInstances(found.contacts),
      ofBodies: found.contacts,
    };
  }

  /** The present frame becomes the start of a step. The next one is its end. */
  beginStep(): void {
    for (const crowd of this.crowds) crowd.beginStep();
  }

  /** What touches in the step, but not at its start. */
  collideMoving(): MovingSceneContacts {
    const found = this.crowds.map((crowd) => crowd.collideMoving({ leaveOutStart: true }));
    const { contacts } = joined(found);
    return { contacts: this.ofInstances(contacts), ofBodies: contacts, times: joinedTimes(found) };
  }

  delete(): void {
    for (const crowd of this.crowds) crowd.delete();
    this.poses?.delete();
  }

  private find({ maxContacts, clearance, budget }: ContactQuestion) {
    if (clearance !== null)
      return this.counted(findNear(this.pelt, this.posed(), clearance, maxContacts ?? Infinity));
    if (budget !== null) return this.counted(findWithBudget(this.pelt, this.posed(), budget));
    return joined(this.crowds.map((crowd) => crowd.collide(limit(maxContacts))));
  }

  /** Leaves out what is ignored. Precondition: no body is tested against itself. */
  private counted<Found extends Pick<CrowdContacts, 'contacts' | 'stats'>>(found: Found) {
    const { contacts, ignored } = this.crowds[0].withoutIgnored(found.contacts);
    return { ...found, count: contacts.length / 4, contacts, ignored, leftOut: NOTHING_LEFT_OUT };
  }

  /** Poses of the bodies in the current frame. */
  private posed(): readonly Pose[] {
    this.poses ??= new BodyPoses(this.characters, this.bodies);
    this.poses.set(this.palettes, this.morphWeights);
    return this.poses.all;
  }

  private makeCrowd(bodies: readonly Body[], ignore: NamePair[]): Crowd {
    const crowd = this.pelt.makeCrowd();
    for (const { instance, part } of bodies) crowd.add(this.characters[instance], part);
    crowd.ignore(ignore);
    return crowd;
  }

  private filter(question: SelfQuestion, filters: SelfFilters): void {
    if (question.isOnly) {
      this.bodies.forEach(({ instance, part }, body) => {
        const filter = filters.filterOf(this.characters[instance], part, question);
        this.crowds[body].setSelfFilter(0, filter);
      });
      return;
    }
    const numbered = this.bodies.map((body, number) => ({ ...body, number }));
    this.characters.forEach((character, instance) => {
      const own = numbered.filter((body) => body.instance === instance);
      setFilters(this.crowds[0], character, own, filters, question);
    });
  }

  /** The crowd of a body, and its number there. */
  private placeOf(body: number): [Crowd, number] {
    return this.crowds.length === 1 ? [this.crowds[0], body] : [this.crowds[body], 0];
  }

  private ofInstances(contacts: Uint32Array): Uint32Array {
    if (this.by === 'instance') return contacts;
    return contacts.map((value, i) => (i % 4 < 2 ? this.bodies[value].instance : value));
  }
}

/** Options of a query that ends after this number of contacts of a pair; null: all contacts. */
export function limit(maxContacts: number | null): CollideOptions {
  return { maxContacts: maxContacts ?? Infinity };
}

/** The answers of crowds of one body each, numbered as in one crowd. */
function joined(found: readonly CrowdContacts[]): CrowdContacts {
  if (found.length === 1) return found[0];
  const contacts = new Uint32Array(found.reduce((sum, one) => sum + one.contacts.length, 0));
  let next = 0;
  found.forEach((one, body) => {
    contacts.set(one.contacts, next);
    for (const end = next + one.contacts.length; next < end; next += 4) {
      contacts[next] = contacts[next + 1] = body;
    }
  });
  return {
    count: contacts.length / 4,
    contacts,
    ignored: found.reduce((sum, { ignored }) => sum + ignored, 0),
    leftOut: sumOfLeftOut(found.map(({ leftOut }) => leftOut)),
    stats: sumOfStats(found.map(({ stats }) => stats)),
  };
}

/** In the order of the joined contacts. */
function joinedTimes(found: readonly CrowdMovingContacts[]): Float32Array {
  const times = new Float32Array(found.reduce((sum, one) => sum + one.times.length, 0));
  let next = 0;
  for (const one of found) {
    times.set(one.times, next);
    next += one.times.length;
  }
  return times;
}

/** Contacts of bodies with themselves, and all others. */
export interface SplitContacts {
  ofSelf: Uint32Array;
  ofPairs: Uint32Array;
}

export function split(found: SceneContacts): SplitContacts {
  const { contacts, ofBodies } = found;
  if (countSelf(found) === 0) return { ofSelf: new Uint32Array(), ofPairs: contacts };
  const isOfSelf = (_: number, i: number) => ofBodies[i & ~3] === ofBodies[(i & ~3) + 1];
  return {
    ofSelf: contacts.filter(isOfSelf),
    ofPairs: contacts.filter((value, i) => !isOfSelf(value, i)),
  };
}

export function countSelf({ ofBodies }: SceneContacts): number {
  let count = 0;
  for (let i = 0; i < ofBodies.length; i += 4) count += Number(ofBodies[i] === ofBodies[i + 1]);
  return count;
}
