import { memo } from './memo';

interface ChartProps {
  counts: readonly number[];
  frameCount: number;
}

/** More than a screen can show. */
const MOST_BARS = 2000;

/** A bar a frame, or for a few of them; roots, so that one contact is seen beside thousands. */
export const Chart = memo(({ counts, frameCount }: ChartProps) => {
  const width = Math.ceil(frameCount / MOST_BARS);
  const bars = mostOfEach(counts, width);
  const most = Math.sqrt(bars.reduce((one, other) => Math.max(one, other), 1));
  const paths = bars.map((count, bar) => {
    const height = count === 0 ? 0 : 0.06 + (0.94 * Math.sqrt(count)) / most;
    return `M${bar * width} 1v${-height}h${width}v${height}z`;
  });
  return (
    <svg viewBox={`0 0 ${frameCount} 1`} preserveAspectRatio="none" aria-hidden="true">
      <rect class="counted" width={counts.length} height="1" />
      <path d={paths.join('')} />
    </svg>
  );
});

/** The largest of each `width` counts. */
export function mostOfEach(counts: readonly number[], width: number): number[] {
  const most = new Array<number>(Math.ceil(counts.length / width)).fill(0);
  counts.forEach((count, i) => {
    const bar = Math.floor(i / width);
    most[bar] = Math.max(most[bar], count);
  });
  return most;
}
