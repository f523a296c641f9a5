/** How the state may change, one function for each thing that one can do. */

import { arrange } from '../scene/arrange';
import { withInstance, type Instance } from '../scene/scene';
import type { Opened, SweepProgress } from '../worker/protocol';
import { isDark } from '../theme';
import type { Problem, State } from './state';

type Change = (state: State) => Partial<State>;

/** Frames follow each other in a circle. */
export function toFrame(frame: number): Change {
  return ({ scene }) => {
    const count = scene?.frameCount ?? 1;
    return { frame: ((frame % count) + count) % count };
  };
}

/** Steps stop what plays. */
export function step(frames: number): Change {
  return (state) => ({ ...toFrame(state.frame + frames)(state), isPlaying: false });
}

/** To the first frame in contact of the next stretch of them, or the last before. */
export function jumpToContact(direction: 1 | -1): Change {
  return (state) => {
    const frame = nextContact(state.sweep.counts, state.frame, direction);
    return frame === null ? {} : { frame, isPlaying: false };
  };
}

/** Where contacts begin; round the clip, nothing if there are none. */
function nextContact(counts: readonly number[], from: number, direction: 1 | -1): number | null {
  const begins = counts.flatMap((count, frame) => (count > 0 && !counts[frame - 1] ? [frame] : []));
  if (begins.length === 0) return null;
  if (direction > 0) return begins.find((frame) => frame > from) ?? begins[0];
  return begins.findLast((frame) => frame < from) ?? begins[begins.length - 1];
}

export const togglePlaying: Change = ({ isPlaying }) => ({ isPlaying: !isPlaying });
export const toggleFirstContact: Change = ({ firstContact }) => ({ firstContact: !firstContact });
export const toggleBoxes: Change = ({ boxLevel }) => ({ boxLevel: boxLevel === null ? 3 : null });
export const toggleTheme: Change = ({ theme }) => ({ theme: isDark(theme) ? 'light' : 'dark' });
export const toggleHelp: Change = ({ isHelpOpen }) => ({ isHelpOpen: !isHelpOpen });

/** Levels of the deepest tree; less than the root's hides the boxes. */
export function changeBoxLevel(by: 1 | -1): Change {
  return ({ boxLevel, characters }) => {
    const deepest = Math.max(...characters.map(({ levelCount }) => levelCount - 1));
    const level = Math.min(deepest, (boxLevel ?? -1) + by);
    return { boxLevel: level < 0 ? null : level };
  };
}

export function select(instance: number | null): Change {
  return () => ({ selected: instance });
}

export function changeInstance(instance: number, change: Partial<Instance>): Change {
  return ({ scene }) => ({ scene: scene && withInstance(scene, instance, change) });
}

/** The new characters take the stage from its first frame on. */
export function open({ characters, scene }: Opened): Change {
  return () => ({
    characters,
    scene: scene ?? arrange(characters),
    reading: null,
    frame: 0,
    isPlaying: true,
    selected: null,
    answer: null,
    costs: null,
    hovered: null,
    problems: [],
  });
}

/** What is on the stage stays there. What is told already is not told again. */
export function refuse(title: string, message: string): Change {
  return ({ problems }) => {
    const others = problems.filter((problem) => problem.message !== message);
    return { reading: null, problems: [...others, { title, message }] };
  };
}

export function dismiss(problem: Problem): Change {
  return ({ problems }) => ({ problems: problems.filter((other) => other !== problem) });
}

/** Progress of a sweep that has been given up is passed over. */
export function sweepOn({ id, counts, total }: SweepProgress): Change {
  return ({ sweep }) =>
    id === sweep.id ? { sweep: { id, counts: [...sweep.counts, ...counts], total } } : {};
}
