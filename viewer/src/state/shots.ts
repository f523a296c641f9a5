/** The shot that the state wants, and whether the answer shows it. */

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

/** Whether the answer is to the scene as it is now, at whatever frame. */
export function isInStep({ answer, scene, by, firstContact, boxLevel, spot }: State): boolean {
  return (
    answer !== null &&
    answer.shot.scene === scene &&
    answer.shot.by === by &&
    answer.shot.firstContact === firstContact &&
    answer.shot.boxLevel === boxLevel &&
    answer.shot.spot === spot
  );
}

/** Whether the displayed frame is earlier than the wanted one. */
export function isLate({ answer, isPlaying, frame }: State): boolean {
  return !isPlaying && answer?.shot.frame !== frame;
}

/** While the scene plays, that which all numbers and the picture are of. */
export function frameInPicture({ isPlaying, scene, answer, frame }: State): number {
  return isPlaying && answer?.shot.scene === scene ? answer.shot.frame : frame;
}
