import { bodyColour, cssColour } from '../draw/colours';
import type { State } from '../state/state';
import type { Touch } from '../worker/protocol';

/** Which instances touch, where there are more than two. */
export function Pairs({ state, touches }: { state: State; touches: readonly Touch[] }) {
  if (touches.length === 0 || (state.scene?.instances.length ?? 0) < 3) return null;
  return (
    <table class="pairs">
      <caption class="quiet">instances that touch</caption>
      {contactsOfPairs(touches).map(({ a, b, contacts }) => (
        <tr>
          <td>
            <Name state={state} instance={a} />
          </td>
          <td>
            <Name state={state} instance={b} />
          </td>
          <td class="number">{contacts.toLocaleString('en')}</td>
        </tr>
      ))}
    </table>
  );
}

function Name({ state, instance }: { state: State; instance: number }) {
  const character = state.scene?.instances[instance]?.character;
  return (
    <span class="place">
      <i class="dot" style={{ background: cssColour(bodyColour(instance)) }} />
      {character === undefined ? '' : state.characters[character].name} <small>{instance}</small>
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
