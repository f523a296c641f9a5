import type { Counts } from '../state/counts';
import { isInRange } from '../state/frames';
import type { FrameRange } from '../worker/protocol';
import { memo } from './memo';

interface ChartProps {
  counts: Counts;
  /** Contacts of characters with themselves, which are among these. */
  selfCounts: Counts;
  frameCount: number;
  /** Null if all frames are checked. */
  checked: FrameRange | null;
}

/** More than a screen can show. */
const MOST_BARS = 2000;

/** A bar a frame, or for a few of them; roots, so that one contact is seen beside thousands. */
export const Chart = memo(({ counts, selfCounts, frameCount, checked }: ChartProps) => {
  const width = Math.ceil(frameCount / MOST_BARS);
  const bars = mostOfEach(counts, width);
  const most = Math.sqrt(bars.reduce((one, other) => Math.max(one, other), 1));
  const pathOf = (count: number, bar: number) => {
    const height = count === 0 ? 0 : 0.06 + (0.94 * Math.sqrt(count)) / most;
    return `M${bar * width} 1v${-height}h${width}v${height}z`;
  };
  return (
    <>
      <svg viewBox={`0 0 ${frameCount} 1`} preserveAspectRatio="none" aria-hidden="true">
        <rect class="counted" width={counts.length} height="1" />
        <path d={bars.map(pathOf).join('')} />
        <path class="of-self" d={mostOfEach(selfCounts, width).map(pathOf).join('')} />
      </svg>
      {checked && <Unchecked checked={checked} frameCount={frameCount} width={width} />}
    </>
  );
});

interface UncheckedProps extends Pick<ChartProps, 'frameCount'> {
  checked: FrameRange;
  /** Frames per bar. */
  width: number;
}

/** Hatches the bars without a checked frame; not in the drawing above, which is stretched. */
function Unchecked({ checked, frameCount, width }: UncheckedProps) {
  const percent = (frames: number) => `${(100 * frames) / frameCount}%`;
  return (
    <svg class="unchecked" aria-hidden="true">
      <pattern id="hatch" width="5" height="5" patternUnits="userSpaceOnUse">
        <path d="M0 5L5 0" />
      </pattern>
      {uncheckedRuns(checked, frameCount, width).map(([begin, end]) => (
        <rect x={percent(begin)} width={percent(end - begin)} height="100%" fill="url(#hatch)" />
      ))}
    </svg>
  );
}

/** Returns the begin and the end of each run of bars without a checked frame, in frames. */
export function uncheckedRuns(
  checked: FrameRange,
  frameCount: number,
  width: number,
): [number, number][] {
  const runs: [number, number][] = [];
  for (let begin = 0; begin < frameCount; begin += width) {
    const end = Math.min(begin + width, frameCount);
    const frames = Array.from({ length: end - begin }, (_, i) => begin + i);
    if (frames.some((frame) => isInRange(frame, checked))) continue;
    const last = runs.at(-1);
    if (last?.[1] === begin) last[1] = end;
    else runs.push([begin, end]);
  }
  return runs;
}

/** The largest of each `width` counts. */
export function mostOfEach(counts: Counts, width: number): number[] {
  const most = new Array<number>(Math.ceil(counts.length / width)).fill(0);
  counts.forEach((count, i) => {
    const bar = Math.floor(i / width);
    most[bar] = Math.max(most[bar], count ?? 0);
  });
  return most;
}
