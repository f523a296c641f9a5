/** A scene at one of its frames: a crowd for queries, and poses for drawing. */

import type { Character, Pelt, Pose, Scene as EngineScene } from 'pelt';
import { Poses } from './poses';
import type { By } from './protocol';
import { SceneCrowd, type SceneContacts } from './scene_crowd';
import { TriangleSets } from './triangle_sets';

export class Stage {
  private crowd: SceneCrowd | null = null;
  private posed: Poses | null = null;
  /** For collecting triangles of the instances. */
  sets = new TriangleSets([]);

  constructor(private readonly pelt: Pelt) {}

  /** Memory for these instances is reused from frame to frame. */
  set(scene: EngineScene, frame: number, by: By): void {
    if (!this.crowd?.fits(scene, by)) this.make(scene, by);
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

  collide(firstContact: boolean): SceneContacts {
    return this.crowd!.collide(firstContact);
  }

  clear(): void {
    this.crowd?.delete();
    this.posed?.delete();
    this.crowd = this.posed = null;
  }

  private make(scene: EngineScene, by: By): void {
    this.clear();
    this.crowd = new SceneCrowd(this.pelt, scene, by);
    this.posed = new Poses(scene, this.crowd);
    this.sets = new TriangleSets(this.characters.map(({ triangleCount }) => triangleCount));
  }
}
