/** Whether the query of the page compares anything. */

import type { State } from './state';

/** Returns why no two bodies are compared, or null if some are. */
export function whyNothingIsCompared({
  scene,
  characters,
  by,
}: Pick<State, 'scene' | 'characters' | 'by'>): string | null {
  if (!scene) return null;
  const partsOf = (character: number) => (by === 'part' ? characters[character].partCount : 1);
  const bodies = scene.instances.reduce((sum, { character }) => sum + partsOf(character), 0);
  if (bodies > 1) return null;
  return `the scene has fewer than two ${by === 'part' ? 'parts' : 'characters'}`;
}
