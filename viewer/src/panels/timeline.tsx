import { jumpToContact, step, toFrame, togglePlaying } from '../state/changes';
import { frameTime } from '../scene/scene';
import type { State, SweepState } from '../state/state';
import type { PanelProps } from './panel_props';
import { Chart } from './chart';
import { memo } from './memo';

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
          onInput={({ currentTarget }) =>
            update((now) => ({ ...toFrame(Number(currentTarget.value))(now), isPlaying: false }))
          }
        />
      </div>
      <div class="facts">
        <output>
          frame <b data-fact="frame">{frame}</b> of {scene.frameCount}
          <small> · {frameTime(scene, frame).toFixed(3)} s</small>
        </output>
        <SweepFacts sweep={sweep} frameCount={scene.frameCount} />
      </div>
    </footer>
  );
}

/** While the scene plays, that which all numbers and the picture are of. */
function frameInPicture({ isPlaying, scene, answer, frame }: State): number {
  return isPlaying && answer?.shot.scene === scene ? answer.shot.frame : frame;
}

function Transport({ state: { isPlaying }, update }: PanelProps) {
  return (
    <div class="transport" role="group" aria-label="Playing">
      <button
        title="Previous contact (P)"
        aria-label="Previous contact"
        onClick={() => update(jumpToContact(-1))}
      >
        ⇤
      </button>
      <button
        title="Previous frame (←)"
        aria-label="Previous frame"
        onClick={() => update(step(-1))}
      >
        ‹
      </button>
      <button
        class="play"
        title={`${isPlaying ? 'Pause' : 'Play'} (Space)`}
        aria-label={isPlaying ? 'Pause' : 'Play'}
        onClick={() => update(togglePlaying)}
      >
        {isPlaying ? '❚❚' : '▶'}
      </button>
      <button title="Next frame (→)" aria-label="Next frame" onClick={() => update(step(1))}>
        ›
      </button>
      <button
        title="Next contact (N)"
        aria-label="Next contact"
        onClick={() => update(jumpToContact(1))}
      >
        ⇥
      </button>
    </div>
  );
}

interface SweepFactsProps {
  sweep: SweepState;
  frameCount: number;
}

const SweepFacts = memo(({ sweep, frameCount }: SweepFactsProps) => {
  const { counts, total } = sweep;
  if (!total) {
    return <small>counting {Math.floor((100 * counts.length) / frameCount)} %</small>;
  }
  const contacts = counts.reduce((sum, count) => sum + count, 0);
  const touched = counts.filter((count) => count > 0).length;
  return (
    <small title="As `pelt check` prints them">
      <span data-fact="total">{contacts.toLocaleString('en')}</span> contacts in {touched} frames
      {total.hash && (
        <>
          {' · '}
          <code data-fact="hash">{total.hash}</code>
        </>
      )}
    </small>
  );
});
