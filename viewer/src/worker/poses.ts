import type { Pose, Scene as EngineScene } from 'pelt';
import type { SceneCrowd } from './scene_crowd';

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
