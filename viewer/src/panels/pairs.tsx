import type { State } from '../state/state';
import type { Touch } from '../worker/protocol';
import { withCommas } from '../words';
import { Badge } from './badge';

/** Lists the touching instances if they may be others than the first two. */
export function Pairs({ state, touches }: { state: State; touches: readonly Touch[] }) {
  const pairs = contactsOfPairs(touches);
  if (pairs.length === 0 || (pairs.length === 1 && state.scene?.instances.length === 2))
    return null;
  return (
    <div class="pairs">
      <table>
        <caption class="quiet">characters that touch</caption>
        {pairs.map(({ a, b, contacts }) => (
          <tr>
            <td>
              <Name state={state} instance={a} />
            </td>
            <td>
              <Name state={state} instance={b} />
            </td>
            <td>{withCommas(contacts)}</td>
          </tr>
        ))}
      </table>
    </div>
  );
}

function Name({ state, instance }: { state: State; instance: number }) {
  const character = state.scene?.instances[instance]?.character;
  return (
    <span class="place">
      <Badge instance={instance} />
      <span>{character === undefined ? '' : state.characters[character].name}</span>
    </span>
  );
}

interface PairCount {
  a: number;
  b: number;
  contacts: number;
}

/** The most contacts first. */
function contactsOfPairs(touches: readonly Touch[]): PairCount[] {
  const pairs = new Map<string, PairCount>();
  for (const { a, b, contacts } of touches) {
    const key = `${a.instance} ${b.instance}`;
    const pair = pairs.get(key) ?? { a: a.instance, b: b.instance, contacts: 0 };
    pairs.set(key, { ...pair, contacts: pair.contacts + contacts });
  }
  return [...pairs.values()].sort((one, other) => other.contacts - one.contacts);
}
