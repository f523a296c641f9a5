/** What of a scene collides: its instances, or all parts of them. */

import type { Scene as EngineScene } from 'pelt';
import type { By } from './protocol';

export interface Body {
  instance: number;
  /** null: all of it. */
  part: number | null;
}

/** In the order in which the command numbers them: parts without triangles are none. */
export function bodiesOf({ instances, characters }: EngineScene, by: By): Body[] {
  if (by === 'instance') return instances.map((_, instance) => ({ instance, part: null }));
  return instances.flatMap(({ character }, instance) =>
    characters[character].parts.flatMap(({ triangleCount }, part) =>
      triangleCount > 0 ? [{ instance, part }] : [],
    ),
  );
}
