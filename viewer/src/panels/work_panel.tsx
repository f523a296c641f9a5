import { toggleWork } from '../state/changes';
import { isSameQuery } from '../state/shots';
import type { MeasuredShot, State } from '../state/state';
import { counted, withCommas } from '../words';
import type { PanelProps } from './panel_props';

/** Compares the work of the displayed frame with that of refitting everything; folded at first. */
export function WorkPanel({ state, update }: PanelProps) {
  const { scene, costs, isWorkOpen } = state;
  if (!scene) return null;
  return (
    <section aria-labelledby="work">
      <h2>
        <button
          class="fold"
          aria-expanded={isWorkOpen}
          title="Compare the work of this frame with that of refitting all boxes first"
          onClick={() => update(toggleWork)}
        >
          <span id="work">Work</span>
        </button>
        {isWorkOpen && costs && <Ratio costs={costs} />}
      </h2>
      {isWorkOpen && <Numbers state={state} />}
    </section>
  );
}

/** Counts are those of the displayed frame, measurements those of the named ones. */
function Numbers({ state: { answer, costs, isPlaying } }: { state: State }) {
  const work = answer?.work;
  const isOfFrame = costs !== null && answer !== null && isSameQuery(costs.shot, answer.shot);
  // While the scene plays, the frames coincide only by chance, and the note would flicker.
  const isEarlier = costs !== null && (isPlaying || !isOfFrame);
  const measured = isEarlier ? measuredIn(costs) : null;
  return (
    <table class="work">
      <thead>
        <tr>
          <th scope="col">this frame</th>
          <th scope="col">on demand</th>
          <th scope="col">refit all</th>
        </tr>
      </thead>
      <tbody>
        <Row name="boxes refitted" fact="boxes" value={work?.refits} whole={work?.allRefits} />
        <Row
          name="vertices skinned"
          fact="vertices"
          value={work?.posedVertices}
          whole={work?.allVertices}
        />
        <Row
          name="triangle tests"
          fact="tests"
          value={work?.trianglePairs}
          whole={isEarlier ? undefined : costs?.eager.trianglePairs}
        />
        <Row
          name="nodes opened"
          fact="nodes"
          note={measured}
          value={costs?.openedNodes}
          whole={costs?.nodes}
        />
        <Row
          name="microseconds"
          fact="microseconds"
          note={measured}
          value={costs?.onDemand.microseconds}
          whole={costs?.eager.microseconds}
        />
      </tbody>
    </table>
  );
}

function measuredIn({ frames, shot }: MeasuredShot): string {
  return frames > 1 ? `mean of ${counted(frames, 'frame')}` : `in frame ${shot.frame}`;
}

/** Compares the microseconds below it. */
function Ratio({ costs: { onDemand, eager } }: { costs: MeasuredShot }) {
  return (
    <small class="number" title="Microseconds of “on demand”, compared with “refit all”">
      {ratioInWords(eager.microseconds / onDemand.microseconds)}
    </small>
  );
}

/** Differences below this share are within what measurements vary by. */
const SMALL_DIFFERENCE = 0.05;

export function ratioInWords(ratio: number): string {
  if (Math.abs(ratio - 1) < SMALL_DIFFERENCE) return 'as fast';
  return ratio > 1 ? `${shortened(ratio)}× faster` : `${shortened(1 / ratio)}× slower`;
}

interface RowProps {
  name: string;
  /** Identifies the numbers in the page, for tests. */
  fact: string;
  /** Set if the numbers are not those of the displayed frame. */
  note?: string | null;
  value: number | undefined;
  whole: number | undefined;
}

function Row({ name, fact, note = null, value, whole }: RowProps) {
  const share = value !== undefined && whole ? Math.min(1, value / whole) : 0;
  return (
    <tr class={note ? 'earlier' : ''} title={note ?? ''}>
      <th scope="row">{name}</th>
      <td data-fact={fact} style={{ '--share': share }}>
        {shown(value)}
      </td>
      <td data-fact={`all-${fact}`}>{shown(whole)}</td>
    </tr>
  );
}

function shown(value: number | undefined): string {
  return value === undefined ? '–' : withCommas(Math.round(value));
}

function shortened(ratio: number): string {
  return ratio.toFixed(ratio < 10 ? 1 : 0);
}
