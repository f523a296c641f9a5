/** Turns around the y axis, which points up. */

import type { Quaternion } from './types';

/** Degrees from -180 to 180 by which a rotation turns around y (its twist). */
export function turnOf([, y, , w]: Quaternion): number {
  const degrees = (360 / Math.PI) * Math.atan2(y, w);
  return degrees > 180 ? degrees - 360 : degrees <= -180 ? degrees + 360 : degrees;
}

/** The rotation turned further until its turn is that. */
export function withTurn(rotation: Quaternion, degrees: number): Quaternion {
  const half = ((degrees - turnOf(rotation)) * Math.PI) / 360;
  const [sin, cos] = [Math.sin(half), Math.cos(half)];
  const [x, y, z, w] = rotation;
  return [cos * x + sin * z, cos * y + sin * w, cos * z - sin * x, cos * w - sin * y];
}
