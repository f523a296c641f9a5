/** Segments between the closest points of bodies, drawn over everything. */

import {
  BufferGeometry,
  Group,
  LineBasicMaterial,
  LineSegments,
  Points,
  PointsMaterial,
} from 'three';
import type { ClosestPoints } from '../worker/protocol';
import { CLOSEST } from './colours';
import { upload } from './upload';

/** In pixels. */
const END_SIZE = 6;

const OVER_ALL = { color: CLOSEST, depthTest: false, toneMapped: false };

export class ClosestLines extends Group {
  private readonly ends = new BufferGeometry();

  constructor() {
    super();
    this.add(
      new LineSegments(this.ends, new LineBasicMaterial(OVER_ALL)),
      new Points(
        this.ends,
        new PointsMaterial({ ...OVER_ALL, size: END_SIZE, sizeAttenuation: false }),
      ),
    );
    for (const child of this.children) {
      child.frustumCulled = false;
      child.renderOrder = 1; // after the triangles in contact
    }
  }

  show(closest: readonly ClosestPoints[]): void {
    this.visible = closest.length > 0;
    if (this.visible)
      upload(this.ends, 'position', Float32Array.from(closest.flatMap(({ points }) => points)));
  }
}
