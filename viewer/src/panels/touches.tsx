import { useState } from 'preact/hooks';
import { worstFirst } from '../report/baseline';
import { lookAt } from '../state/changes';
import type { State, Update } from '../state/state';
import type { Spot, Surface, Touch } from '../worker/protocol';
import { counted, withCommas } from '../words';
import type { PanelProps } from './panel_props';
import { Place } from './place';
import { Worse } from './worse';

/** Number of rows, unless all are shown. */
const FEW = 40;

/** Largest number of triangles listed as text. */
const MOST_TRIANGLES = 2000;

/** Places that touch; each leads to where it is worst. */
export function Touches({ touches, state, update }: PanelProps & { touches: readonly Touch[] }) {
  const [areAllShown, showAll] = useState(false);
  if (touches.length === 0) return <p class="nothing quiet">Nothing touches.</p>;
  const several = ofSeveralParts(touches);
  const sorted = worstFirst(touches, state);
  const shown = areAllShown ? sorted : sorted.slice(0, FEW);
  return (
    <ol class="touches" onKeyDown={moveFocus}>
      {shown.map((touch, i) => (
        <Row
          isFirst={i === 0}
          touch={touch}
          several={several}
          isOpen={isAt(state.spot, touch)}
          state={state}
          update={update}
        />
      ))}
      {touches.length > FEW && (
        <li>
          <button class="quiet more" onClick={() => showAll(!areAllShown)}>
            {areAllShown ? 'fewer' : `${touches.length - FEW} more`}
          </button>
        </li>
      )}
    </ol>
  );
}

/** The list is one stop of the Tab key: arrows lead on. */
function moveFocus(event: KeyboardEvent): void {
  const by = { ArrowDown: 1, ArrowUp: -1 }[event.key];
  const list = event.currentTarget as HTMLElement;
  const rows = [...list.querySelectorAll<HTMLElement>('.touch')];
  const at = rows.indexOf(document.activeElement as HTMLElement);
  if (by === undefined || at < 0) return;
  event.preventDefault();
  rows[at + by]?.focus();
}

interface RowProps extends PanelProps {
  touch: Touch;
  /** Instances whose parts have to be distinguished. */
  several: ReadonlySet<number>;
  isFirst: boolean;
  isOpen: boolean;
}

function Row({ touch, several, isFirst, isOpen, state, update }: RowProps) {
  const { a, b, contacts, worst } = touch;
  return (
    <li>
      <button
        class="touch"
        tabIndex={isFirst ? 0 : -1}
        aria-expanded={isOpen}
        title={`Go to frame ${worst.frame}, with ${counted(worst.contacts, 'contact')}`}
        onClick={() => update(isOpen ? lookAt(null) : lookAt({ a, b }, worst.frame))}
      >
        <Place surface={a} withPart={several.has(a.instance)} />
        <Place surface={b} withPart={several.has(b.instance)} />
        <output>{withCommas(contacts)}</output>
        <Worse state={state} touch={touch} />
      </button>
      {isOpen && <Details touch={touch} state={state} update={update} />}
    </li>
  );
}

/** Lists the triangles, and the frames with more of them. */
function Details({ touch: { a, b }, state, update }: Pick<RowProps, 'touch' | keyof PanelProps>) {
  const { answer, sweep } = state;
  if (!answer || !isAt(answer.shot.spot, { a, b })) return null;
  const { spot, shot } = answer;
  const pairs = spot?.pairs ?? new Uint32Array();
  const inClip = sweep.total?.touches.find((touch) => isAt(touch, { a, b }));
  return (
    <div class="details">
      <p class="quiet">
        {withCommas(pairs.length / 2)} in frame {shot.frame}
        {inClip && inClip.worst.frame !== shot.frame && (
          <Worst worst={inClip.worst} spot={{ a, b }} update={update} />
        )}
      </p>
      <p class="triangles" aria-label="Triangles">
        {trianglesInWords(pairs)}
      </p>
    </div>
  );
}

interface WorstProps {
  worst: Touch['worst'];
  spot: Spot;
  update: Update;
}

function Worst({ worst, spot, update }: WorstProps) {
  return (
    <button class="link" onClick={() => update(lookAt(spot, worst.frame))}>
      {withCommas(worst.contacts)} in frame {worst.frame}, at worst
    </button>
  );
}

function trianglesInWords(pairs: Uint32Array): string {
  const words: string[] = [];
  for (let i = 0; i < Math.min(pairs.length, 2 * MOST_TRIANGLES); i += 2) {
    words.push(`${pairs[i]}\u202f×\u202f${pairs[i + 1]}`);
  }
  if (pairs.length > 2 * MOST_TRIANGLES) words.push('…');
  return words.join('  ');
}

function isAt(spot: State['spot'], { a, b }: Spot): boolean {
  return spot !== null && isSame(spot.a, a) && isSame(spot.b, b);
}

function isSame(one: Surface, other: Surface): boolean {
  return one.instance === other.instance && one.part === other.part && one.joint === other.joint;
}

/** Instances that touch with more than one of their parts. */
function ofSeveralParts(touches: readonly Touch[]): ReadonlySet<number> {
  const firstParts = new Map<number, string>();
  const several = new Set<number>();
  for (const { instance, part } of touches.flatMap(({ a, b }) => [a, b])) {
    if (!firstParts.has(instance)) firstParts.set(instance, part);
    else if (firstParts.get(instance) !== part) several.add(instance);
  }
  return several;
}
