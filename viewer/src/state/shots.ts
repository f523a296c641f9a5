/** What the state wants to see. */

import type { State } from './state';
import type { Shot } from '../worker/protocol';

/** While other characters are being read, the worker may have given up those of the scene. */
export function shotOf({
  scene,
  reading,
  frame,
  by,
  firstContact,
  boxLevel,
  spot,
}: State): Shot | null {
  return scene && !reading ? { scene, frame, by, firstContact, boxLevel, spot } : null;
}

export function isSameShot(one: Shot, other: Shot): boolean {
  return isSameQuery(one, other) && one.boxLevel === other.boxLevel && one.spot === other.spot;
}

/** Whether it does the same work. */
export function isSameQuery(one: Shot, other: Shot): boolean {
  return (
    one.scene === other.scene &&
    one.frame === other.frame &&
    one.by === other.by &&
    one.firstContact === other.firstContact
  );
}
