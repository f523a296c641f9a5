/** Sums over records of numbers. */

import type { LeftOut, QueryStats } from 'pelt';

export const NOTHING_LEFT_OUT: LeftOut = {
  takesPart: 0,
  rings: 0,
  atRest: 0,
  always: 0,
  joints: 0,
  groups: 0,
};

export const NO_WORK: QueryStats = {
  nodePairs: 0,
  refits: 0,
  posedVertices: 0,
  trianglePairs: 0,
  displacements: 0,
  clampedOffsets: 0,
  cutShort: false,
};

export function sumOfLeftOut(all: readonly LeftOut[]): LeftOut {
  return all.reduce(sum, NOTHING_LEFT_OUT);
}

export function sumOfStats(all: readonly QueryStats[]): QueryStats {
  const cutShort = all.some((stats) => stats.cutShort);
  return { ...all.reduce(sum, NO_WORK), cutShort };
}

/** Adds up the members, which are numbers. */
function sum<Counts extends object>(one: Counts, other: Counts): Counts {
  const added = Object.entries(one).map(([key, value]) => [
    key,
    value + (other as Record<string, number>)[key],
  ]);
  return Object.fromEntries(added) as Counts;
}
