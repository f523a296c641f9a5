import type { ClipReport } from '../report/report';
import { canChooseClip, chooseClip } from '../state/changes';
import { counted, withCommas } from '../words';
import { useFew } from './few';
import type { PanelProps } from './panel_props';

/** Number of rows, unless all are shown. */
const FEW = 8;

/** The clips of a report of all clips, the worst first. A click shows another clip. */
export function ClipsPanel({ state, update }: PanelProps) {
  const { reel, report } = state;
  const clips = [...(reel?.clips ?? [])].sort((a, b) => (b.worst ?? 0) - (a.worst ?? 0));
  const { shown, more } = useFew(clips, FEW);
  if (!canChooseClip(state)) return null;
  return (
    <section aria-labelledby="clips">
      <h2>
        <span id="clips">Clips</span>
        <small>{summaryOf(clips)}</small>
      </h2>
      <ol class="pairs clips">
        {shown.map((clip) => (
          <li>
            <button
              class="touch"
              aria-pressed={clip.report === report}
              title={`Show this clip${clip.worst ? ' at its worst frame' : ''}`}
              onClick={() => update(chooseClip(clip))}
            >
              <span>{clip.clip || 'unnamed'}</span>
              <small>{framesOf(clip)}</small>
              <span class="count">{clip.worst !== null && withCommas(clip.worst)}</span>
            </button>
          </li>
        ))}
        {more && <li>{more}</li>}
      </ol>
    </section>
  );
}

function summaryOf(clips: readonly ClipReport[]): string {
  if (clips.every(({ worst }) => worst === null)) return counted(clips.length, 'clip');
  const inContact = clips.filter(({ worst }) => worst).length;
  return `${inContact} of ${counted(clips.length, 'clip')} in contact`;
}

function framesOf({ framesInContact, report, frameCount }: ClipReport): string {
  const { answer } = report;
  if (!answer) return counted(frameCount, 'frame');
  return `${withCommas(framesInContact ?? 0)} of ${counted(answer.totals.frames, 'frame')}`;
}
