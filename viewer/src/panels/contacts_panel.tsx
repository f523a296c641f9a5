import type { ComponentChildren } from 'preact';
import { isOneBody } from '../scene/self';
import { checkAllFrames, decideAll, pauseAt } from '../state/changes';
import { showsStills, totalsOf, undecidedFrames } from '../state/counts';
import { rearrange } from '../state/edits';
import { checkedFrames, rangeInWords } from '../state/frames';
import { filtered, isOfSelf, listedTouches } from '../state/listing';
import { asksPairs, asksSelf, isLate, whyNothingIsCompared } from '../state/shots';
import type { State } from '../state/state';
import { counted, withCommas } from '../words';
import type { Touch } from '../worker/protocol';
import { BetweenFrames } from './between';
import { ClosestList, Pairs } from './pairs';
import type { PanelProps } from './panel_props';
import { QuerySwitches, SelfSwitch } from './query_switches';
import { SameNumbers } from './same_numbers';
import { SelfFilters } from './self_filters';
import { Filters, Gone, Touches } from './touches';

/** The question, and one list of contacts for each kind of answer. */
export function ContactsPanel({ state, update }: PanelProps) {
  const { answer, sweep, listing } = state;
  return (
    <section class="contacts" aria-labelledby="contacts">
      <h2>
        <span id="contacts">Contacts</span>
        <Count state={state} />
      </h2>
      <div class="row">
        <div class="choice" role="group" aria-label="Listed contacts">
          {(['frame', 'clip'] as const).map((choice) => (
            <button
              aria-pressed={listing === choice}
              onClick={() => update(() => ({ listing: choice }))}
            >
              {choice === 'frame' ? 'this frame' : 'whole clip'}
            </button>
          ))}
        </div>
        <SelfSwitch state={state} update={update} />
      </div>
      <QuerySwitches state={state} update={update} />
      {asksSelf(state) && <SelfFilters state={state} update={update} />}
      <Checked state={state} update={update} />
      <Budget state={state} update={update} />
      <Ignored count={listing === 'clip' ? sweep.total?.ignored : answer?.ignored} />
      <SameNumbers state={state} />
      <BetweenFrames state={state} update={update} />
      <ClosestList state={state} />
      <Stills state={state} update={update} />
      <Lists state={state} update={update} />
    </section>
  );
}

/** The contacts of the frame or of the clip. */
function Lists({ state, update }: PanelProps) {
  const { by, filter, listing, report } = state;
  const touches = listedTouches(state);
  if (!touches) return <p class="nothing quiet">Not counted yet …</p>;
  if (touches.length === 0 && filter.standing !== 'gone') {
    return <Nothing state={state} update={update} />;
  }
  const ofPairs = touches.filter((touch) => !isOfSelf(touch, by));
  return (
    <>
      {listing === 'clip' && <Pairs state={state} touches={ofPairs} update={update} />}
      <Filters state={state} update={update} />
      {filter.standing === 'gone' ? (
        <Gone gone={report?.answer?.verdict.gone ?? []} words={filter.words} />
      ) : (
        <>
          <BetweenCharacters state={state} touches={ofPairs} update={update} />
          <WithThemselves state={state} touches={touches} update={update} />
        </>
      )}
    </>
  );
}

type ListProps = PanelProps & { touches: readonly Touch[] };

/** Contacts of different instances or parts; without a title if there are no others. */
function BetweenCharacters({ state, touches, update }: ListProps) {
  if (!asksPairs(state)) return null;
  if (!asksSelf(state))
    return <Touches touches={filtered(touches, state)} state={state} update={update} />;
  if (isAlone(state)) return null;
  return (
    <div class="pairs-list" role="group" aria-labelledby="between">
      <Title id="between" touches={touches} dot="pairs">
        {state.by === 'part' ? 'Between parts' : 'Between characters'}
      </Title>
      <Touches touches={filtered(touches, state)} state={state} update={update} />
    </div>
  );
}

/** Contacts of instances or parts with themselves. */
function WithThemselves({ state, touches, update }: ListProps) {
  if (!asksSelf(state)) return null;
  const own = touches.filter((touch) => isOfSelf(touch, state.by));
  return (
    <div class="self-list" role="group" aria-labelledby="themselves">
      <Title id="themselves" touches={own} dot="self">
        {titleOfSelf(state)}
      </Title>
      <Touches touches={filtered(own, state)} state={state} update={update} />
    </div>
  );
}

function titleOfSelf(state: State): string {
  if (isAlone(state)) return 'The character with itself';
  return state.by === 'part' ? 'Parts with themselves' : 'Characters with themselves';
}

function isAlone({ scene, by, characters }: State): boolean {
  return scene !== null && isOneBody({ scene, by, characters });
}

interface TitleProps {
  id: string;
  touches: readonly Touch[];
  /** Style of the dot, which has the colour of the contacts in the picture. */
  dot: 'pairs' | 'self';
  children: ComponentChildren;
}

function Title({ id, touches, dot, children }: TitleProps) {
  return (
    <h3>
      <i class={`dot of-${dot}`} />
      <span id={id}>{children}</span>
      <span class="count" data-fact={`listed-${dot}`}>
        {withCommas(touches.reduce((sum, { contacts }) => sum + contacts, 0))}
      </span>
    </h3>
  );
}

/** Says that nothing touches or was compared, and how characters meet that walk past each other. */
function Nothing({ state, update }: PanelProps) {
  const reason = whyNothingIsCompared(state);
  if (reason) return <p class="nothing quiet">Nothing was compared: {reason}.</p>;
  const { sweep, arrangement, scene } = state;
  const isNever = sweep.total !== null && totalsOf(sweep.counts).contacts === 0;
  const walksPast = isNever && arrangement === 'walking' && scene!.instances.length > 1;
  return (
    <div class="nothing quiet">
      <p>{nothingInWords(state, isNever)}</p>
      {walksPast && (
        <button class="link" onClick={() => update(rearrange('together'))}>
          Put all in the same place
        </button>
      )}
    </div>
  );
}

function nothingInWords({ answer, listing, sweep }: State, isNever: boolean): string {
  const isUnknown = listing === 'clip' ? sweep.undecided.some((count) => count) : answer?.undecided;
  if (isUnknown) return 'No contact is known. Some pairs of triangles are not decided.';
  return isNever ? 'Nothing touches in any frame.' : 'Nothing touches.';
}

/** Says which frames count, if not all do. */
function Checked({ state, update }: PanelProps) {
  const range = checkedFrames(state);
  if (!range) return null;
  return (
    <p class="quiet checked">
      Checked: frames {rangeInWords(range)}, of 0 to {state.scene!.frameCount - 1}.{' '}
      <button class="link" onClick={() => update(checkAllFrames)}>
        Check all frames
      </button>
    </p>
  );
}

/** Number of listed contacts. */
function Count({ state }: { state: State }) {
  const { answer, sweep, listing } = state;
  const ofClip = sweep.total && totalsOf(sweep.counts).contacts;
  const count = listing === 'clip' ? ofClip : answer?.contacts;
  const classes = [
    'number',
    ...(count ? ['glowing'] : []),
    ...(listing === 'frame' && isLate(state) ? ['late'] : []),
  ];
  return (
    <span class={classes.join(' ')} data-fact="listed">
      {count === undefined || count === null ? '–' : withCommas(count)}
    </span>
  );
}

/** Contacts that the scene says do not count. */
function Ignored({ count }: { count: number | undefined }) {
  if (!count) return null;
  return (
    <p class="quiet">
      <span data-fact="ignored">{withCommas(count)}</span> ignored
    </p>
  );
}

/** Counts the frames that a limit of the work has left undecided. */
function Budget({ state: { budget, sweep }, update }: PanelProps) {
  if (budget === null) return null;
  const { unknown, touching, decided } = undecidedFrames(sweep);
  return (
    <div class="budget">
      <p class="quiet">
        Each pair was given {counted(budget, 'unit')} of work in each frame.{' '}
        <button class="link" onClick={() => update(decideAll)}>
          Find all contacts
        </button>
      </p>
      <ul>
        <BudgetRow
          name="unknown"
          count={unknown}
          meaning="no contact found, some pairs not decided"
        />
        <BudgetRow name="touching" count={touching} meaning="more contacts are possible" />
        <BudgetRow name="decided" count={decided} meaning="all contacts found" />
      </ul>
    </div>
  );
}

interface BudgetRowProps {
  name: string;
  /** Number of frames. */
  count: number;
  meaning: string;
}

function BudgetRow({ name, count, meaning }: BudgetRowProps) {
  return (
    <li>
      <b data-fact={name}>{withCommas(count)}</b> {count === 1 ? 'frame' : 'frames'} {name}:{' '}
      {meaning}
    </li>
  );
}

/** The worst frames; each leads there. */
function Stills({ state, update }: PanelProps) {
  if (!showsStills(state)) return null;
  const { stills } = state;
  return (
    <div class="stills">
      {stills.map(({ frame, contacts, picture }) => (
        <button title={`Go to frame ${frame}`} onClick={() => update(pauseAt(frame))}>
          <img src={picture} alt={`Frame ${frame}`} />
          <span>
            {withCommas(contacts)} <small>frame {frame}</small>
          </span>
        </button>
      ))}
    </div>
  );
}
