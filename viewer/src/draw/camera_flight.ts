/** The camera on its way to another view of the scene. */

import { Vector3, type PerspectiveCamera } from 'three';
import { wantsStillness } from '../theme';

const MILLISECONDS = 450;

interface Sight {
  position: Vector3;
  target: Vector3;
}

export class CameraFlight {
  private readonly begin = performance.now();
  private readonly duration = wantsStillness() ? 0 : MILLISECONDS;

  constructor(
    private readonly from: Sight,
    private readonly to: Sight,
  ) {}

  /** Sets the camera, and the point that it turns around; returns whether it has arrived. */
  move(camera: PerspectiveCamera, target: Vector3, now: number): boolean {
    const share = this.duration === 0 ? 1 : Math.min(1, (now - this.begin) / this.duration);
    const eased = share * share * (3 - 2 * share);
    camera.position.lerpVectors(this.from.position, this.to.position, eased);
    target.lerpVectors(this.from.target, this.to.target, eased);
    return share >= 1;
  }
}
