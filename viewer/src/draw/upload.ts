/** Upload of arrays that change in each frame. */

import { BufferAttribute, DynamicDrawUsage, type BufferGeometry } from 'three';

/** Uploads the array without copying it here. Arrays of the same length reuse the same buffer. */
export function upload(geometry: BufferGeometry, name: string, values: Float32Array): void {
  const present = geometry.getAttribute(name) as BufferAttribute | undefined;
  if (present?.array.length === values.length) {
    present.array = values;
    present.needsUpdate = true;
    return;
  }
  geometry.dispose();
  geometry.setAttribute(name, new BufferAttribute(values, 3).setUsage(DynamicDrawUsage));
}
