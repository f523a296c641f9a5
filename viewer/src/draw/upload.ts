/** Upload of arrays that change in each frame. */

import { BufferAttribute, DynamicDrawUsage, type BufferGeometry } from 'three';

/** Nothing is copied on this side: the array is handed on as it is. Arrays as long as the one before
 * go to the same place. */
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
