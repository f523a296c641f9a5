import type { ClosestPoints } from '../worker/protocol';
import { useFew } from './few';
import type { PanelProps } from './panel_props';
import { Place } from './place';

/** Number of rows, unless all are shown. */
const FEW = 4;

/** Distances of the bodies that are within the clearance, in the displayed frame. */
export function ClosestList({ state }: Pick<PanelProps, 'state'>) {
  const { answer, by } = state;
  const { shown, more } = useFew(answer?.closest ?? [], FEW);
  if (!answer || shown.length === 0) return null;
  return (
    <>
      <h3>Closest points in frame {answer.shot.frame}</h3>
      <ol class="pairs closest">
        {shown.map((closest) => (
          <Row closest={closest} withParts={by === 'part'} />
        ))}
        {more && <li>{more}</li>}
      </ol>
    </>
  );
}

function Row({
  closest: { a, b, distance },
  withParts,
}: {
  closest: ClosestPoints;
  withParts: boolean;
}) {
  return (
    <li class="touch">
      <Place surface={a} withPart={withParts} />
      <Place surface={b} withPart={withParts} />
      <span class="count">{distance === 0 ? 'touch' : distance.toFixed(6)}</span>
    </li>
  );
}
