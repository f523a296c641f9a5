import { comparedAnswer, comparisonOf, worseTouch, worstFirst } from '../report/baseline';
import type { GoneTouch, KnownName } from '../report/report';
import { filterBy, lookAt } from '../state/changes';
import { matches } from '../state/listing';
import type { Filter, State, Update } from '../state/state';
import { counted, withCommas } from '../words';
import type { Spot, Surface, Touch } from '../worker/protocol';
import { Badge } from './badge';
import { useFew } from './few';
import type { PanelProps } from './panel_props';
import { Place } from './place';

/** Number of rows, unless all are shown. */
const FEW = 40;

/** Number of triangles listed as text, unless all are. */
const FEW_TRIANGLES = 60;

/** Largest number of triangles listed as text. */
const MOST_TRIANGLES = 2000;

/** Places that touch; each leads to where it is worst. */
export function Touches({ touches, state, update }: PanelProps & { touches: readonly Touch[] }) {
  const { shown, more } = useFew(worstFirst(touches, state), FEW);
  if (touches.length === 0) return <p class="nothing quiet">No contact matches.</p>;
  const several = ofSeveralParts(touches);
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
      {more && <li>{more}</li>}
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
        <span class="count">{withCommas(contacts)}</span>
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
      <Triangles pairs={pairs} />
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

function Triangles({ pairs }: { pairs: Uint32Array }) {
  const { shown, more } = useFew(trianglesInWords(pairs), FEW_TRIANGLES);
  return (
    <>
      <p class="triangles" aria-label="Triangles">
        {shown.join('  ')}
      </p>
      {more}
    </>
  );
}

function trianglesInWords(pairs: Uint32Array): string[] {
  const words: string[] = [];
  for (let i = 0; i < Math.min(pairs.length, 2 * MOST_TRIANGLES); i += 2) {
    words.push(`${pairs[i]}\u202f×\u202f${pairs[i + 1]}`);
  }
  if (pairs.length > 2 * MOST_TRIANGLES) words.push('…');
  return words;
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

/** Shows how a touch is worse than in the baseline: both numbers of contacts. */
function Worse({ state, touch }: { state: State; touch: Touch }) {
  const found = worseTouch(touch, state);
  if (!found) return null;
  const { worst, known } = found;
  const isNew = known === 0;
  return (
    <small class="worse" title="Contacts in the worst frame, now and in the baseline">
      <b class={isNew ? 'standing new' : 'standing grown'}>{isNew ? 'new' : 'grown'}</b>
      {` ${withCommas(worst.contacts)} in frame ${worst.frame}`}
      {!isNew && `, was ${withCommas(known)}`}
    </small>
  );
}

/** Contacts of the baseline that the check did not find. */
export function Gone({ gone, words }: { gone: readonly GoneTouch[]; words: string }) {
  const listed = gone.filter(({ a, b }) => matches(words, `${nameOf(a)} ${nameOf(b)}`));
  const { shown, more } = useFew(listed, FEW);
  if (listed.length === 0) return <p class="nothing quiet">No contact is gone.</p>;
  return (
    <ol class="touches gone">
      {shown.map(({ a, b, known }) => (
        <li title={`${counted(known, 'contact')} in the worst frame of the baseline`}>
          <span>{nameOf(a)}</span>
          <span>{nameOf(b)}</span>
          <span class="count">was {known}</span>
        </li>
      ))}
      {more && <li>{more}</li>}
    </ol>
  );
}

function nameOf({ model, copy, part = '', joint }: KnownName): string {
  return [model, copy > 0 ? `(${copy})` : '', part, joint].filter((word) => word !== '').join(' ');
}

/** Restricts the list of contacts. */
export function Filters({ state, update }: PanelProps) {
  const { words, pair } = state.filter;
  return (
    <div class="filters">
      <input
        type="search"
        placeholder="Search joints, parts, characters"
        aria-label="Search contacts"
        value={words}
        onInput={({ currentTarget }) => update(filterBy({ words: currentTarget.value }))}
      />
      {pair && (
        <button
          class="chip"
          title="List all pairs"
          onClick={() => update(filterBy({ pair: null }))}
        >
          only <Badge instance={pair[0]} /> and <Badge instance={pair[1]} /> ×
        </button>
      )}
      <Standings state={state} update={update} />
    </div>
  );
}

/** Shown beside a baseline. */
function Standings({ state, update }: PanelProps) {
  const answer = comparedAnswer(state);
  const comparison = answer && comparisonOf(answer);
  if (!comparison) return null;
  const { fresh, grown, known, gone } = comparison;
  const choices: [Filter['standing'], number][] = [
    ['new', fresh],
    ['grown', grown],
    ['known', known],
    ['gone', gone],
  ];
  return (
    <div class="choice" role="group" aria-label="Beside the baseline">
      {choices.map(([standing, count]) => (
        <button
          aria-pressed={state.filter.standing === standing}
          onClick={() =>
            update(filterBy({ standing: state.filter.standing === standing ? null : standing }))
          }
        >
          {`${withCommas(count)} ${standing}`}
        </button>
      ))}
    </div>
  );
}
