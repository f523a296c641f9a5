import { isSameQuery } from '../state/shots';
import type { MeasuredShot } from '../state/state';
import { withCommas } from '../words';
import type { PanelProps } from './panel_props';

/** Shows the counts of the displayed frame. Measurements may belong to an earlier frame, which is named. */
export function WorkPanel({ state: { scene, answer, costs, isPlaying } }: PanelProps) {
  if (!scene) return null;
  const work = answer?.work;
  const isOfFrame = costs !== null && answer !== null && isSameQuery(costs.shot, answer.shot);
  // While the scene plays, the frames coincide only by chance, and the note would flicker.
  const isEarlier = costs !== null && (isPlaying || !isOfFrame);
  const measured = isEarlier ? `in frame ${costs.shot.frame}` : null;
  return (
    <section aria-labelledby="work">
      <h2 id="work">
        Work of this frame
        {costs && <Ratio costs={costs} />}
      </h2>
      <table class="work">
        <thead>
          <tr>
            <th />
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
    </section>
  );
}

function Ratio({ costs: { ratio } }: { costs: MeasuredShot }) {
  return (
    <small class="number" title="Time on demand, compared with refitting everything first">
      {ratio >= 1 ? `${shortened(ratio)}× less` : `${shortened(1 / ratio)}× more`}
    </small>
  );
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
