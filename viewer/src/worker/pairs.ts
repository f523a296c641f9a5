import type { Contacts, Pose } from 'pelt';

/** Contacts of the instances a < b. */
export interface PairContacts {
  a: number;
  b: number;
  contacts: Contacts;
}

/** Asks every pair of poses. */
export function queryPairs(
  poses: readonly Pose[],
  query: (a: Pose, b: Pose) => Contacts,
): PairContacts[] {
  return poses.flatMap((poseA, a) =>
    poses.slice(a + 1).map((poseB, i) => ({ a, b: a + 1 + i, contacts: query(poseA, poseB) })),
  );
}
