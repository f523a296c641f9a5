import type { Pose, Scene as EngineScene } from 'pelt';

/** A pose for each instance of a scene, kept from frame to frame. */
export class Poses {
  all: Pose[] = [];

  /** Closes all nodes that queries have opened. */
  set(scene: EngineScene, frame: number): void {
    if (!this.fits(scene)) this.make(scene);
    this.all.forEach((pose, instance) => scene.setPose(pose, instance, frame));
  }

  clear(): void {
    for (const pose of this.all) pose.delete();
    this.all = [];
  }

  private fits({ instances, characters }: EngineScene): boolean {
    return (
      instances.length === this.all.length &&
      instances.every(({ character }, i) => this.all[i].character === characters[character])
    );
  }

  private make({ instances, characters }: EngineScene): void {
    this.clear();
    this.all = instances.map(({ character }) => characters[character].makePose());
  }
}
