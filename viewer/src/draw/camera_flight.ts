/** The camera on its way to another view of the scene, around what it looks at. */

import { Spherical, Vector3, type PerspectiveCamera } from 'three';
import { wantsStillness } from '../theme';

const MILLISECONDS = 450;

interface Sight {
  position: Vector3;
  target: Vector3;
}

export class CameraFlight {
  private readonly begin = performance.now();
  private readonly duration = wantsStillness() ? 0 : MILLISECONDS;
  private readonly fromAway: Spherical;
  private readonly toAway: Spherical;

  constructor(
    private readonly from: Sight,
    private readonly to: Sight,
  ) {
    this.fromAway = awayOf(from);
    this.toAway = awayOf(to);
    this.toAway.theta = this.fromAway.theta + shorter(this.toAway.theta - this.fromAway.theta);
  }

  /** Sets the camera, and the point that it turns around; returns whether it has arrived. */
  move(camera: PerspectiveCamera, target: Vector3, now: number): boolean {
    const share = this.duration === 0 ? 1 : Math.min(1, (now - this.begin) / this.duration);
    const eased = share * share * (3 - 2 * share);
    target.lerpVectors(this.from.target, this.to.target, eased);
    camera.position.copy(target).add(this.awayAt(eased));
    return share >= 1;
  }

  private awayAt(share: number): Vector3 {
    const between = (one: number, other: number) => one + share * (other - one);
    const [from, to] = [this.fromAway, this.toAway];
    const away = new Spherical(
      between(from.radius, to.radius),
      between(from.phi, to.phi),
      between(from.theta, to.theta),
    );
    return new Vector3().setFromSpherical(away);
  }
}

function awayOf({ position, target }: Sight): Spherical {
  return new Spherical().setFromVector3(position.clone().sub(target));
}

/** The same angle, in the range of half a turn in either direction. */
function shorter(angle: number): number {
  return angle - 2 * Math.PI * Math.round(angle / (2 * Math.PI));
}
