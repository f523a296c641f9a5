/** Bodies of a scene: its instances, or all their parts. */

import type { Scene as EngineScene } from 'pelt';
import type { By } from './protocol';

export interface Body {
  instance: number;
  /** null: all of it. */
  part: number | null;
}

/** Same order as in the command, without parts that have no triangles. */
export function bodiesOf({ instances, characters }: EngineScene, by: By): Body[] {
  if (by === 'instance') return instances.map((_, instance) => ({ instance, part: null }));
  return instances.flatMap(({ character }, instance) =>
    characters[character].parts.flatMap(({ triangleCount }, part) =>
      triangleCount > 0 ? [{ instance, part }] : [],
    ),
  );
}
