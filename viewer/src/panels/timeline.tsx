import type { JSX } from 'preact';
import { frameTime, isInRange } from '../scene/scene';
import { jumpToContact, pauseAt, step, togglePlaying } from '../state/changes';
import { totalsOf } from '../state/counts';
import { checkedFrames } from '../state/frames';
import { frameInPicture, isInStep, isLate, momentOf, whyNothingIsCompared } from '../state/shots';
import type { Change, State, SweepState, Update } from '../state/state';
import { knownSteps } from '../state/steps';
import { counted, withCommas } from '../words';
import { betweenInWords } from './between';
import { Chart } from './chart';
import { memo } from './memo';
import type { PanelProps } from './panel_props';

export function Timeline({ state, update }: PanelProps) {
  const { scene, sweep } = state;
  if (!scene) return <footer class="time" />;
  const frame = frameInPicture(state);
  const moment = momentOf(state);
  const time = moment ? frame + moment.share * (moment.to - frame) : frame;
  return (
    <footer class="time">
      <Transport state={state} update={update} />
      <div class="chart" {...scrubbing(scene.frameCount, update)}>
        <Chart
          counts={sweep.counts}
          selfCounts={sweep.selfCounts}
          undecided={sweep.undecided}
          frameCount={scene.frameCount}
          checked={checkedFrames(state)}
        />
        <StepMarks state={state} />
        <i class="playhead" style={{ left: `${(100 * (time + 0.5)) / scene.frameCount}%` }} />
        <input
          type="range"
          min={0}
          max={String(scene.frameCount - 1)}
          value={String(frame)}
          aria-label="Frame"
          aria-valuetext={`frame ${frame}, ${contactsInWords(sweep.counts[frame])}`}
          onInput={({ currentTarget }) => update(pauseAt(Number(currentTarget.value)))}
        />
      </div>
      <div class="facts">
        <FrameFacts state={state} frame={frame} />
        <Announcement state={state} frame={frame} />
        <SweepFacts
          sweep={sweep}
          frameCount={scene.frameCount}
          compares={whyNothingIsCompared(state) === null}
        />
      </div>
    </footer>
  );
}

/** Marks the steps with contacts between their frames. */
function StepMarks({ state }: { state: State }) {
  const steps = knownSteps(state);
  if (!steps || steps.length === 0) return null;
  const percent = (frames: number) => `${(100 * frames) / state.scene!.frameCount}%`;
  return (
    <svg class="steps-between" aria-label={betweenInWords(steps)} role="img">
      {steps.map(({ frame, first: { to } }) => (
        <rect x={percent(frame + 0.5)} width={percent(to - frame)} height="5" />
      ))}
    </svg>
  );
}

function contactsInWords(count: number | null | undefined): string {
  if (count === null) return 'not checked';
  return count === undefined ? 'not yet counted' : counted(count, 'contact');
}

/** Goes to the frame whose bar is under the pressed pointer. */
function scrubbing(frameCount: number, update: Update) {
  const goTo = ({ currentTarget, clientX, buttons }: JSX.TargetedPointerEvent<HTMLElement>) => {
    if ((buttons & 1) === 0) return; // only the main button
    const { left, width } = currentTarget.getBoundingClientRect();
    const frame = Math.floor(((clientX - left) / width) * frameCount);
    update(pauseAt(Math.min(Math.max(0, frame), frameCount - 1)));
  };
  return {
    onPointerMove: goTo,
    onPointerDown: (event: JSX.TargetedPointerEvent<HTMLElement>) => {
      event.currentTarget.setPointerCapture(event.pointerId);
      goTo(event);
    },
  };
}

function Transport({ state, update }: PanelProps) {
  const { isPlaying, scene, sweep } = state;
  const common = { update, problem: scene!.frameCount === 1 ? 'The scene has one frame only' : '' };
  const hasNone =
    sweep.total !== null && sweep.counts.every((count) => !count) && !knownSteps(state)?.length;
  const ofContacts = { ...common, problem: hasNone ? 'There are no contacts' : common.problem };
  return (
    <div class="transport" role="group" aria-label="Playing">
      <Button
        {...ofContacts}
        name="Previous contact"
        keyName="P"
        change={jumpToContact(-1)}
        sign="⇤"
      />
      <Button {...common} name="Previous frame" keyName="←" change={step(-1)} sign="‹" />
      <Button
        {...common}
        isLarge
        name={isPlaying ? 'Pause' : 'Play'}
        keyName="Space"
        change={togglePlaying}
        sign={isPlaying ? '❚❚' : '▶'}
      />
      <Button {...common} name="Next frame" keyName="→" change={step(1)} sign="›" />
      <Button {...ofContacts} name="Next contact" keyName="N" change={jumpToContact(1)} sign="⇥" />
    </div>
  );
}

interface ButtonProps {
  name: string;
  keyName: string;
  sign: string;
  change: Change;
  isLarge?: boolean;
  /** Why the button can do nothing; empty if it can. */
  problem: string;
  update: Update;
}

function Button({ name, keyName, sign, change, isLarge = false, problem, update }: ButtonProps) {
  return (
    <button
      class={isLarge ? 'play' : ''}
      title={problem || `${name} (${keyName})`}
      aria-label={name}
      disabled={problem !== ''}
      onClick={() => update(change)}
    >
      {sign}
    </button>
  );
}

/** Numbers beside the timeline: of the frame, and of all of them. */
function FrameFacts({ state, frame }: { state: State; frame: number }) {
  const { scene, answer } = state;
  const count = scene!.frameCount;
  const moment = momentOf(state);
  const step = knownSteps(state)?.find((one) => one.frame === frame);
  return (
    <p>
      <span>
        frame <b data-fact="frame">{frame}</b>
        <small>
          {moment && ` to ${moment.to}: first contact between them`}
          {!moment && (count > 1 ? ` of 0–${count - 1}` : ', the only one')} ·{' '}
          {moment ? moment.seconds.toFixed(4) : frameTime(scene!, frame).toFixed(3)} s ·{' '}
        </small>
      </span>
      <span
        class={isLate(state) ? 'late' : ''}
        data-answered={isInStep(state) ? answer!.shot.frame : 'earlier'}
      >
        <b data-fact="contacts">{answer ? withCommas(answer.contacts) : '–'}</b>
        <small>
          {answer?.contacts === 1 ? ' contact' : ' contacts'}
          {!isInRange(frame, checkedFrames(state)) && ', not checked'}
          {!!answer?.undecided && `, ${counted(answer.undecided, 'pair')} of triangles not decided`}
          {step && !moment && `, ${withCommas(step.contacts)} more before frame ${step.first.to}`}
        </small>
      </span>
    </p>
  );
}

/** For screen readers. While the scene plays, it would be too much to follow. */
function Announcement({ state, frame }: { state: State; frame: number }) {
  const { answer, isPlaying } = state;
  const isKnown = !isPlaying && isInStep(state) && answer!.shot.frame === frame;
  return (
    <p class="unseen" role="status">
      {isKnown && `frame ${frame}: ${counted(answer!.contacts, 'contact')}`}
    </p>
  );
}

interface SweepFactsProps {
  sweep: SweepState;
  frameCount: number;
  /** Whether the query compares anything. */
  compares: boolean;
}

const SweepFacts = memo(({ sweep, frameCount, compares }: SweepFactsProps) => {
  const { counts, undecided, searched, total } = sweep;
  const percentOf = (frames: number) => `${Math.floor((100 * frames) / frameCount)} %`;
  if (!total && searched > 0 && counts.length === 0) {
    return <small>looking for what always touches {percentOf(searched)}</small>;
  }
  if (!total) return <small>counting {percentOf(counts.length)}</small>;
  const { contacts, inContact, checked } = totalsOf(counts);
  const notDecided = undecided.filter((count) => count).length;
  return (
    <small title="The same numbers as in `pelt check`">
      <span data-fact="total">{withCommas(contacts)}</span>
      {contacts === 1 ? ' contact' : ' contacts'} in{' '}
      {frameCount > 1 && `${withCommas(inContact)} of `}
      {counted(checked, checked === frameCount ? 'frame' : 'checked frame')}
      {notDecided > 0 && ` · ${withCommas(notDecided)} not decided`}
      {!compares && ' · nothing was compared'}
      {total.hash && (
        <>
          {' · '}
          <code data-fact="hash">{total.hash}</code>
        </>
      )}
    </small>
  );
});
