import { filterBy } from '../state/changes';
import type { State, Update } from '../state/state';
import { withCommas } from '../words';
import type { ClosestPoints, Touch } from '../worker/protocol';
import { Badge } from './badge';
import { useFew } from './few';
import type { PanelProps } from './panel_props';
import { Place } from './place';

/** Number of rows, unless all are shown. */
const FEW = 4;

interface PairsProps {
  state: State;
  touches: readonly Touch[];
  update: Update;
}

/**
 * Lists the touching instances if they may be others than the first two. A click restricts the
 * list of contacts to a pair.
 */
export function Pairs({ state, touches, update }: PairsProps) {
  const pairs = contactsOfPairs(touches);
  const { shown, more } = useFew(pairs, FEW);
  if (pairs.length === 0 || (pairs.length === 1 && state.scene?.instances.length === 2))
    return null;
  return (
    <>
      <h3>Characters that touch</h3>
      <ol class="pairs">
        {shown.map((pair) => (
          <Row pair={pair} state={state} update={update} />
        ))}
        {more && <li>{more}</li>}
      </ol>
    </>
  );
}

function Row({ pair, state, update }: { pair: PairCount; state: State; update: Update }) {
  const { a, b, contacts } = pair;
  const { pair: listed } = state.filter;
  const isListed = listed?.[0] === a && listed[1] === b;
  return (
    <li>
      <button
        class="touch"
        aria-pressed={isListed}
        title={isListed ? 'List all pairs' : 'List only the contacts of this pair'}
        onClick={() => update(filterBy({ pair: isListed ? null : [a, b] }))}
      >
        <Name state={state} instance={a} />
        <Name state={state} instance={b} />
        <span class="count">{withCommas(contacts)}</span>
      </button>
    </li>
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

/** Distances of the bodies that are within the clearance, in the displayed frame. */
export function ClosestList({ state }: Pick<PanelProps, 'state'>) {
  const { answer, by } = state;
  const { shown, more } = useFew(answer?.closest ?? [], FEW);
  if (!answer || shown.length === 0) return null;
  return (
    <>
      <h3>Closest points in frame {answer.shot.frame}</h3>
      <ol class="pairs closest">
        {shown.map((closest) => (
          <ClosestRow closest={closest} withParts={by === 'part'} />
        ))}
        {more && <li>{more}</li>}
      </ol>
    </>
  );
}

function ClosestRow({
  closest: { a, b, distance },
  withParts,
}: {
  closest: ClosestPoints;
  withParts: boolean;
}) {
  return (
    <li class="touch">
      <Place surface={a} withPart={withParts} />
      <Place surface={b} withPart={withParts} />
      <span class="count">{distance === 0 ? 'touch' : distance.toFixed(6)}</span>
    </li>
  );
}
