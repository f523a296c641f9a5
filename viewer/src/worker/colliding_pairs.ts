import type { Bounds, Pose } from 'pelt';

/** The pairs of poses whose boxes overlap. */
export function collidingPairs(poses: readonly Pose[]): [Pose, Pose][] {
  return pairsWithin(poses, 0).map(([a, b]) => [poses[a], poses[b]]);
}

/** The pairs of poses whose boxes are at most this far apart along each axis, ascending. */
export function pairsWithin(poses: readonly Pose[], distance: number): [number, number][] {
  const boxes = poses.map((pose) => pose.bounds().box);
  return boxes.flatMap((box, a) =>
    boxes
      .slice(a + 1)
      .flatMap((other, i): [number, number][] =>
        areWithin(box, other, distance) ? [[a, a + 1 + i]] : [],
      ),
  );
}

/** More than all roundings of a difference. */
const SLACK = 1 + 1e-9;

function areWithin(one: Bounds['box'], other: Bounds['box'], distance: number): boolean {
  return [0, 1, 2].every(
    (axis) =>
      one.low[axis] - other.high[axis] <= distance * SLACK &&
      other.low[axis] - one.high[axis] <= distance * SLACK,
  );
}
