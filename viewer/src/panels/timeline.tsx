import { jumpToContact, pauseAt, step, togglePlaying, type Change } from '../state/changes';
import { frameInPicture } from '../state/shots';
import type { Update } from '../state/state';
import type { PanelProps } from './panel_props';
import { Chart } from './chart';
import { FrameFacts, SweepFacts } from './clip_facts';

export function Timeline({ state, update }: PanelProps) {
  const { scene, sweep } = state;
  if (!scene) return <footer class="time" />;
  const frame = frameInPicture(state);
  return (
    <footer class="time">
      <Transport state={state} update={update} />
      <div class="chart">
        <Chart counts={sweep.counts} frameCount={scene.frameCount} />
        <input
          type="range"
          min={0}
          max={String(scene.frameCount - 1)}
          value={String(frame)}
          aria-label="Frame"
          aria-valuetext={`frame ${frame}, ${sweep.counts[frame] ?? 'not yet counted'} contacts`}
          onInput={({ currentTarget }) => update(pauseAt(Number(currentTarget.value)))}
        />
      </div>
      <div class="facts">
        <FrameFacts state={state} frame={frame} />
        <SweepFacts sweep={sweep} frameCount={scene.frameCount} />
      </div>
    </footer>
  );
}

function Transport({ state: { isPlaying, scene }, update }: PanelProps) {
  const common = { isIdle: scene!.frameCount === 1, update };
  return (
    <div class="transport" role="group" aria-label="Playing">
      <Button {...common} name="Previous contact" keyName="P" change={jumpToContact(-1)} sign="⇤" />
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
      <Button {...common} name="Next contact" keyName="N" change={jumpToContact(1)} sign="⇥" />
    </div>
  );
}

interface ButtonProps {
  name: string;
  keyName: string;
  sign: string;
  change: Change;
  isLarge?: boolean;
  /** There is no other frame. */
  isIdle: boolean;
  update: Update;
}

function Button({ name, keyName, sign, change, isLarge = false, isIdle, update }: ButtonProps) {
  return (
    <button
      class={isLarge ? 'play' : ''}
      title={isIdle ? 'The scene has one frame only' : `${name} (${keyName})`}
      aria-label={name}
      disabled={isIdle}
      onClick={() => update(change)}
    >
      {sign}
    </button>
  );
}
