/**
 * Contacts of characters with themselves: the choices of a scene, their defaults, and their words in
 * scene files and command lines (docs/self-collision.md).
 */

import type { By, CharacterFacts, FrameRange, SelfQuestion } from '../worker/protocol';
import type { Scene, SelfChoices } from './types';

export type SelfWanted = 'off' | 'also' | 'only';

const USUAL_RINGS = 5;
export const MOST_RINGS = 64;

/** Share that is dropped once the filter is turned on. */
export const USUAL_SHARE = 0.95;

/** The keys of a scene file. `JSON.stringify` leaves out what is undefined. */
export function selfKeys({ wanted, rings, dropsAtRest, always, dropsNearJoints }: SelfChoices) {
  const kept = (drops: boolean | undefined) => (drops === undefined ? drops : keepOrDrop(drops));
  return {
    self: wanted && { off: false, also: true, only: 'only' }[wanted],
    self_rings: rings,
    self_at_rest: kept(dropsAtRest),
    self_always: always === null ? 'keep' : always,
    self_near_joints: kept(dropsNearJoints),
  };
}

export function keepOrDrop(drops: boolean): 'keep' | 'drop' {
  return drops ? 'drop' : 'keep';
}

/** The defaults depend on these. */
export interface SelfAsking {
  scene: Scene;
  by: By;
  characters: readonly CharacterFacts[];
  self: SelfChoices;
}

/** Whether there is only one body, whose contacts with itself are then its only ones. */
export function isOneBody({ scene, by, characters }: Omit<SelfAsking, 'self'>): boolean {
  const [first, ...others] = scene.instances;
  if (!first || others.length > 0) return false;
  return by === 'instance' || characters[first.character].partCount === 1;
}

export function wantedSelf(asking: SelfAsking): SelfWanted {
  return asking.self.wanted ?? usualSelf(asking);
}

function usualSelf(asking: SelfAsking): SelfWanted {
  return isOneBody(asking) ? 'also' : 'off';
}

/** Whether a pose of the scene can differ from the default pose; otherwise all contacts are at rest. */
function posesAnything({ instances }: Scene): boolean {
  return instances.some(
    ({ clip, morphWeights }) => clip !== null || Object.keys(morphWeights).length > 0,
  );
}

/** The choices of the filters, with defaults. */
export function selfRules({ scene, self }: Pick<SelfAsking, 'scene' | 'self'>) {
  return {
    rings: self.rings ?? USUAL_RINGS,
    dropsAtRest: self.dropsAtRest ?? posesAnything(scene),
    always: self.always ?? null,
    dropsNearJoints: self.dropsNearJoints ?? true,
  };
}

/** Returns null if no body is tested against itself. `frames` are those that are checked. */
export function selfQuestion(asking: SelfAsking, frames: FrameRange | null): SelfQuestion | null {
  const wanted = wantedSelf(asking);
  if (wanted === 'off') return null;
  const rules = selfRules(asking);
  const isOnly = wanted === 'only';
  return { isOnly, ...rules, frames: rules.always === null ? null : frames };
}

export function isSameSelf(one: SelfQuestion | null, other: SelfQuestion | null): boolean {
  return one === other || JSON.stringify(one) === JSON.stringify(other);
}

/** The options of `pelt check`, without defaults. */
export function selfWords(asking: SelfAsking): string[] {
  const wanted = wantedSelf(asking);
  const words =
    wanted === usualSelf(asking)
      ? []
      : { off: ['--self=no'], also: ['--self'], only: ['--self=only'] }[wanted];
  if (wanted === 'off') return words;
  const { rings, dropsAtRest, always, dropsNearJoints } = selfRules(asking);
  const usual = selfRules({ ...asking, self: {} });
  return [
    ...words,
    ...(rings === usual.rings ? [] : ['--self-rings', String(rings)]),
    ...(dropsAtRest === usual.dropsAtRest ? [] : ['--self-at-rest', keepOrDrop(dropsAtRest)]),
    ...(always === null ? [] : ['--self-always', String(always)]),
    ...(dropsNearJoints === usual.dropsNearJoints
      ? []
      : ['--self-near-joints', keepOrDrop(dropsNearJoints)]),
  ];
}
