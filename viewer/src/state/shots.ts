/** The shot that the state wants, and whether the answer shows it. */

import { isSameSelf, selfQuestion, wantedSelf } from '../scene/self';
import type { Moment, SelfQuestion, Shot } from '../worker/protocol';
import { checkedFrames } from './frames';
import type { State } from './state';

/** How bodies are tested against themselves; null if they are not, or if there is no scene. */
export function selfOf(state: State): SelfQuestion | null {
  const { scene, by, characters, self } = state;
  return scene && selfQuestion({ scene, by, characters, self }, checkedFrames(state));
}

export function asksSelf(state: State): boolean {
  return selfOf(state) !== null;
}

/** Whether bodies are tested against each other. */
export function asksPairs(state: State): boolean {
  return selfOf(state)?.isOnly !== true;
}

/** The time after the frame that is shown; null for the frame itself. It ends with any change. */
export function momentOf({ moment, scene, frame, isPlaying }: State): Moment | null {
  if (!moment || isPlaying || moment.scene !== scene || moment.frame !== frame) return null;
  return moment.moment;
}

/** While other characters are being read, the worker may have given up those of the scene. */
export function shotOf(state: State): Shot | null {
  const { scene, reading, frame, by, maxContacts, clearance, budget, boxLevel, spot } = state;
  if (!scene || reading) return null;
  const [self, moment] = [selfOf(state), momentOf(state)];
  return { scene, frame, moment, by, maxContacts, clearance, budget, self, boxLevel, spot };
}

export function isSameShot(one: Shot, other: Shot): boolean {
  return isSameQuery(one, other) && one.boxLevel === other.boxLevel && one.spot === other.spot;
}

/** Whether it does the same work. */
export function isSameQuery(one: Shot, other: Shot): boolean {
  return (
    one.scene === other.scene &&
    one.frame === other.frame &&
    one.moment === other.moment &&
    one.by === other.by &&
    one.maxContacts === other.maxContacts &&
    one.clearance === other.clearance &&
    one.budget === other.budget &&
    isSameSelf(one.self, other.self)
  );
}

/** Whether the answer is to the scene as it is now, at whatever frame. */
export function isInStep(state: State): boolean {
  const { answer, scene, by, maxContacts, clearance, budget, boxLevel, spot } = state;
  return (
    answer !== null &&
    !answer.isPreliminary &&
    isSameSelf(answer.shot.self, selfOf(state)) &&
    answer.shot.scene === scene &&
    answer.shot.by === by &&
    answer.shot.maxContacts === maxContacts &&
    answer.shot.clearance === clearance &&
    answer.shot.budget === budget &&
    answer.shot.boxLevel === boxLevel &&
    answer.shot.spot === spot &&
    (answer.shot.moment === null || answer.shot.moment === momentOf(state))
  );
}

/** Whether the displayed frame is earlier than the wanted one. */
export function isLate(state: State): boolean {
  const { answer, isPlaying, frame } = state;
  const isShown = answer?.shot.frame === frame && answer.shot.moment === momentOf(state);
  return !isPlaying && !isShown;
}

/** While the scene plays, that which all numbers and the picture are of. */
export function frameInPicture({ isPlaying, scene, answer, frame }: State): number {
  return isPlaying && answer?.shot.scene === scene ? answer.shot.frame : frame;
}

/** Returns why no body is compared with another one or with itself, or null if some are. */
export function whyNothingIsCompared({
  scene,
  characters,
  by,
  self,
}: Pick<State, 'scene' | 'characters' | 'by' | 'self'>): string | null {
  if (!scene || wantedSelf({ scene, characters, by, self }) !== 'off') return null;
  const partsOf = (character: number) => (by === 'part' ? characters[character].partCount : 1);
  const bodies = scene.instances.reduce((sum, { character }) => sum + partsOf(character), 0);
  if (bodies > 1) return null;
  const things = by === 'part' ? 'parts' : 'characters';
  return `the scene has fewer than two ${things}, and “self” is off`;
}
