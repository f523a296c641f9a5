/** A scene at one of its frames: a crowd for queries, and poses for drawing. */

import type { Character, Pelt, Pose, Scene as EngineScene } from 'pelt';
import { TriangleSets } from './glow';
import type { SelfFilters } from './own_contacts';
import type { By, ContactQuestion, SelfQuestion } from './protocol';
import { limit, SceneCrowd, type SceneContacts } from './scene_crowd';

export class Stage {
  private crowd: SceneCrowd | null = null;
  private posed: Poses | null = null;
  private question: SelfQuestion | null = null;
  /** For collecting triangles of the instances. */
  sets = new TriangleSets([]);

  constructor(
    private readonly pelt: Pelt,
    private readonly filters: SelfFilters,
  ) {}

  /** Memory for these instances is reused from frame to frame. */
  set(scene: EngineScene, frame: number, by: By, question: SelfQuestion | null): void {
    const test = { question, filters: this.filters };
    if (!this.crowd?.fits(scene, by, test)) this.make(scene, by, question);
    this.crowd!.set(scene, frame);
    this.posed!.follow();
  }

  get poses(): readonly Pose[] {
    return this.posed?.all ?? [];
  }

  /** Poses by body. */
  get colliding(): readonly Pose[] {
    return this.posed?.colliding ?? [];
  }

  /** Poses of the bodies of one instance. */
  collidingOf(instance: number): readonly Pose[] {
    return this.posed?.collidingOf(instance) ?? [];
  }

  get characters(): Character[] {
    return this.crowd?.characters ?? [];
  }

  collide(question: ContactQuestion): SceneContacts {
    return this.crowd!.collide(question);
  }

  /** Whether contacts of bodies with themselves are found, if they are asked for. */
  get isReady(): boolean {
    return this.crowd!.isReady;
  }

  /** Tests the poses of all bodies against themselves. Returns the number of tested triangles. */
  collideSelf(maxContacts: number | null): number {
    const { question, filters } = this;
    if (!question || !this.isReady) return 0;
    return this.colliding.reduce((sum, pose) => {
      const filter = filters.filterOf(pose.character, pose.part, question);
      return sum + this.pelt.selfCollide(pose, filter, limit(maxContacts)).stats.trianglePairs;
    }, 0);
  }

  clear(): void {
    this.crowd?.delete();
    this.posed?.delete();
    this.crowd = this.posed = null;
  }

  private make(scene: EngineScene, by: By, question: SelfQuestion | null): void {
    this.clear();
    this.question = question;
    this.crowd = new SceneCrowd(this.pelt, scene, by, { question, filters: this.filters });
    this.posed = new Poses(scene, this.crowd);
    this.sets = new TriangleSets(this.characters.map(({ triangleCount }) => triangleCount));
  }
}

/** One pose per instance of a scene, for drawing and for queries of one instance. */
export class Poses {
  readonly all: Pose[];
  /** Poses by body, in which nodes are opened. Same as above if bodies are instances. */
  readonly colliding: Pose[];

  constructor(
    { instances, characters }: EngineScene,
    private readonly crowd: SceneCrowd,
  ) {
    this.all = instances.map(({ character }) => characters[character].makePose());
    this.colliding = crowd.bodies.map(({ instance, part }) =>
      part === null ? this.all[instance] : this.all[instance].character.makePose(part),
    );
  }

  /** Poses of an instance. */
  collidingOf(instance: number): Pose[] {
    return this.colliding.filter((_, body) => this.crowd.bodies[body].instance === instance);
  }

  /** Takes what the crowd has been set to. Closes all nodes that queries have opened. */
  follow(): void {
    this.all.forEach((pose, i) => this.set(pose, i));
    this.crowd.bodies.forEach(({ instance, part }, body) => {
      if (part !== null) this.set(this.colliding[body], instance);
    });
  }

  delete(): void {
    for (const pose of new Set([...this.all, ...this.colliding])) pose.delete();
  }

  private set(pose: Pose, instance: number): void {
    pose.setMorphWeights(this.crowd.morphWeights[instance]);
    pose.setPalette(this.crowd.palettes[instance]);
  }
}
