import type { PanelProps } from './app';

export function WorkPanel({ state }: PanelProps) {
  const { answer, costs } = state;
  if (!answer) return null;
  const { work } = answer;
  const ratio = costs && costs.eager.microseconds / costs.onDemand.microseconds;
  return (
    <section aria-labelledby="work">
      <h2 id="work">
        Work of this frame
        {ratio && (
          <small class="number" title="Time on demand beside that of refitting everything first">
            {ratio >= 1 ? `${shortened(ratio)}× less` : `${shortened(1 / ratio)}× more`}
          </small>
        )}
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
          <Row name="nodes opened" fact="nodes" value={work.openedNodes} whole={work.nodes} />
          <Row
            name="vertices skinned"
            fact="vertices"
            value={work.posedVertices}
            whole={work.vertices}
          />
          <Row
            name="triangle tests"
            fact="tests"
            value={work.trianglePairs}
            whole={work.trianglePairs}
          />
          <Row
            name="microseconds"
            fact="microseconds"
            value={costs?.onDemand.microseconds}
            whole={costs?.eager.microseconds}
          />
        </tbody>
      </table>
    </section>
  );
}

interface RowProps {
  name: string;
  /** For whoever looks for the numbers in the page. */
  fact: string;
  value: number | undefined;
  whole: number | undefined;
}

function Row({ name, fact, value, whole }: RowProps) {
  const share = value !== undefined && whole ? Math.min(1, value / whole) : 0;
  return (
    <tr>
      <th scope="row">{name}</th>
      <td data-fact={fact} style={{ '--share': share }}>
        {shown(value)}
      </td>
      <td data-fact={`all-${fact}`}>{shown(whole)}</td>
    </tr>
  );
}

function shown(value: number | undefined): string {
  return value === undefined ? '–' : Math.round(value).toLocaleString('en');
}

function shortened(ratio: number): string {
  return ratio.toFixed(ratio < 10 ? 1 : 0);
}
