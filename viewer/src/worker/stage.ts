/** A scene at one of its frames: a crowd for queries, and poses for drawing. */

import type { Character, Pelt, Pose, Scene as EngineScene } from 'pelt';
import type { SelfFilters } from './own_contacts';
import { Poses } from './poses';
import type { By, ContactQuestion, SelfQuestion } from './protocol';
import { limit, SceneCrowd, type SceneContacts } from './scene_crowd';
import { TriangleSets } from './triangle_sets';

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
