import type { Surface } from '../worker/protocol';
import { Badge } from './badge';

/** A place on a character. */
export function Place({ surface, withPart }: { surface: Surface; withPart: boolean }) {
  const { instance, part, joint } = surface;
  return (
    <span class="place" title={`${instance} · ${part} · ${joint}`}>
      <Badge instance={instance} />
      <span>
        <Breakable name={joint} />
        {withPart && (
          <small>
            {' '}
            <Breakable name={materialOf(part)} />
          </small>
        )}
      </span>
    </span>
  );
}

/** A name that is broken between its words, if it has to be. */
function Breakable({ name }: { name: string }) {
  const words = name.split(/(?<=[_.:|-])/);
  return (
    <>
      {words.map((word) => (
        <>
          {word}
          <wbr />
        </>
      ))}
    </>
  );
}

/** Parts of one node are called "node:material". */
function materialOf(part: string): string {
  return part.slice(part.indexOf(':') + 1);
}
