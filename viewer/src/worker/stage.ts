/** A scene at one of its frames: its instances as a crowd, which queries ask, and as poses. */

import type { Character, CrowdContacts, Pelt, Pose, Scene as EngineScene } from 'pelt';
import { Poses } from './poses';
import { SceneCrowd } from './scene_crowd';
import { TriangleSets } from './triangle_sets';

export class Stage {
  private crowd: SceneCrowd | null = null;
  private posed: Poses | null = null;
  /** For whoever gathers triangles of the instances. */
  sets = new TriangleSets([]);

  constructor(private readonly pelt: Pelt) {}

  /** What lies in memory for these instances is kept from frame to frame. */
  set(scene: EngineScene, frame: number): void {
    if (!this.crowd?.fits(scene)) this.make(scene);
    this.crowd!.set(scene, frame);
    this.posed!.follow(this.crowd!);
  }

  get poses(): readonly Pose[] {
    return this.posed?.all ?? [];
  }

  get characters(): Character[] {
    return this.crowd?.characters ?? [];
  }

  collide(firstContact: boolean): CrowdContacts {
    return this.crowd!.collide(firstContact);
  }

  clear(): void {
    this.crowd?.delete();
    this.posed?.delete();
    this.crowd = this.posed = null;
  }

  private make(scene: EngineScene): void {
    this.clear();
    this.crowd = new SceneCrowd(this.pelt, scene);
    this.posed = new Poses(scene);
    this.sets = new TriangleSets(this.characters.map(({ triangleCount }) => triangleCount));
  }
}
