/** Whether the query of the page compares anything. */

import { wantedSelf } from '../scene/self';
import type { State } from './state';

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
