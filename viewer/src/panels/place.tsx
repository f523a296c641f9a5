import type { Surface } from '../worker/protocol';
import { Badge } from './badge';

/** A place on a character. */
export function Place({ surface, withPart }: { surface: Surface; withPart: boolean }) {
  const { instance, part, joint } = surface;
  return (
    <span class="place" title={`${instance} · ${part} · ${joint}`}>
      <Badge instance={instance} />
      <span>
        {joint}
        {withPart && <small> {materialOf(part)}</small>}
      </span>
    </span>
  );
}

/** Parts of one node are called "node:material". */
function materialOf(part: string): string {
  return part.slice(part.indexOf(':') + 1);
}
