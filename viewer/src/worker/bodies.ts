/** Bodies of a scene: its instances, or all their parts. */

import type { Character, Scene as EngineScene } from 'pelt';
import type { By } from './protocol';

export interface Body {
  instance: number;
  /** null: all of it. */
  part: number | null;
}

/** Same order as in the command, without parts that have no triangles. */
export function bodiesOf({ instances, characters }: EngineScene, by: By): Body[] {
  return instances.flatMap(({ character }, instance) =>
    partsOf(characters[character], by).map((part) => ({ instance, part })),
  );
}

/** The parts of one instance; null for all of it. */
export function partsOf({ parts }: Character, by: By): Body['part'][] {
  if (by === 'instance') return [null];
  return parts.flatMap(({ triangleCount }, part) => (triangleCount > 0 ? [part] : []));
}
