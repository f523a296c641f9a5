import { isInRange } from '../scene/scene';
import type { Counts } from '../state/counts';
import type { FrameRange } from '../worker/protocol';
import { memo } from './memo';

interface ChartProps {
  counts: Counts;
  /** Contacts of characters with themselves, which are among these. */
  selfCounts: Counts;
  /** Pairs of triangles that are not decided. */
  undecided: Counts;
  frameCount: number;
  /** Null if all frames are checked. */
  checked: FrameRange | null;
}

/** More than a screen can show. */
const MOST_BARS = 2000;

/** A bar a frame, or for a few of them; roots, so that one contact is seen beside thousands. */
export const Chart = memo((props: ChartProps) => {
  const { counts, selfCounts, undecided, frameCount, checked } = props;
  const width = Math.ceil(frameCount / MOST_BARS);
  const isUndecided = mostOfEach(undecided, width).map((pairs) => pairs > 0);
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
      {isUndecided.includes(true) && (
        <Hatching name="undecided" runs={runsOf(isUndecided, width, frameCount)} {...props} />
      )}
      {checked && (
        <Hatching name="unchecked" runs={uncheckedRuns(checked, frameCount, width)} {...props} />
      )}
    </>
  );
});

interface HatchingProps extends Pick<ChartProps, 'frameCount'> {
  /** Why the bars are hatched: their class. */
  name: 'unchecked' | 'undecided';
  /** Begin and end of each run of hatched bars, in frames. */
  runs: [number, number][];
}

/** Hatches bars; not in the drawing above, which is stretched. */
function Hatching({ name, runs, frameCount }: HatchingProps) {
  const percent = (frames: number) => `${(100 * frames) / frameCount}%`;
  return (
    <svg class={name} aria-hidden="true">
      <pattern id={`hatch-${name}`} width="5" height="5" patternUnits="userSpaceOnUse">
        <path d="M0 5L5 0" />
      </pattern>
      {runs.map(([begin, end]) => (
        <rect
          x={percent(begin)}
          width={percent(end - begin)}
          height="100%"
          fill={`url(#hatch-${name})`}
        />
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
  const isUnchecked = Array.from({ length: Math.ceil(frameCount / width) }, (_, bar) => {
    const end = Math.min((bar + 1) * width, frameCount);
    for (let frame = bar * width; frame < end; ++frame) if (isInRange(frame, checked)) return false;
    return true;
  });
  return runsOf(isUnchecked, width, frameCount);
}

/** Returns the begin and the end of each run of hatched bars, in frames. */
function runsOf(isHatched: boolean[], width: number, frameCount: number): [number, number][] {
  const runs: [number, number][] = [];
  isHatched.forEach((isOne, bar) => {
    const [begin, end] = [bar * width, Math.min((bar + 1) * width, frameCount)];
    const last = runs.at(-1);
    if (isOne && last?.[1] === begin) last[1] = end;
    else if (isOne) runs.push([begin, end]);
  });
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
