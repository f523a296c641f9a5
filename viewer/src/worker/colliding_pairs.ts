import type { Bounds, Pose } from 'pelt';

/** The pairs of poses whose boxes overlap. */
export function collidingPairs(poses: readonly Pose[]): [Pose, Pose][] {
  const boxes = poses.map((pose) => pose.bounds().box);
  return poses.flatMap((a, i) =>
    poses
      .slice(i + 1)
      .flatMap((b, j): [Pose, Pose][] => (overlap(boxes[i], boxes[i + 1 + j]) ? [[a, b]] : [])),
  );
}

function overlap(one: Bounds['box'], other: Bounds['box']): boolean {
  return [0, 1, 2].every(
    (axis) => one.low[axis] <= other.high[axis] && other.low[axis] <= one.high[axis],
  );
}
