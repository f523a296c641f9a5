/** All changes of the state, one function for each action of the user. */

import { findingOf } from '../report/verdict';
import { arrange, join, USUAL_ARRANGEMENT } from '../scene/arrange';
import { castOf, duplicated, without } from '../scene/cast';
import { meetsItself } from '../scene/notes';
import { inWholeClips, withFps, withInstance, type Instance, type Scene } from '../scene/scene';
import type {
  CharacterFacts,
  Opened,
  ReadCharacters,
  ReadingOptions,
  Refusal,
  Spot,
  SweepProgress,
} from '../worker/protocol';
import { isDark, wantsStillness } from '../theme';
import type { Counts } from './counts';
import { edit } from './history';
import { NO_FILTER, type Filter } from './listing';
import type { CameraMove, Problem, State } from './state';

export type Change = (state: State) => Partial<State>;

/** Frames follow each other in a circle. */
export function toFrame(frame: number): Change {
  return ({ scene }) => {
    const count = scene?.frameCount ?? 1;
    return { frame: ((frame % count) + count) % count };
  };
}

/** Goes to a frame and pauses. */
export function pauseAt(frame: number): Change {
  return (state) => ({ ...toFrame(frame)(state), isPlaying: false });
}

/** Steps stop what plays. */
export function step(frames: number): Change {
  return (state) => pauseAt(state.frame + frames)(state);
}

/** Jumps to the nearest start of a range of frames in contact, forwards or backwards. */
export function jumpToContact(direction: 1 | -1): Change {
  return (state) => {
    const frame = nextContact(state.sweep.counts, state.frame, direction);
    return frame === null ? {} : { frame, isPlaying: false };
  };
}

/** Goes to the next first frame of contact, cyclically; does nothing without contacts. */
function nextContact(counts: Counts, from: number, direction: 1 | -1): number | null {
  const begins = counts.flatMap((count, frame) => (count && !counts[frame - 1] ? [frame] : []));
  if (begins.length === 0) return null;
  if (direction > 0) return begins.find((frame) => frame > from) ?? begins[0];
  return begins.findLast((frame) => frame < from) ?? begins[begins.length - 1];
}

export const togglePlaying: Change = ({ isPlaying }) => ({ isPlaying: !isPlaying });
export const toggleBy: Change = ({ by }) => ({ by: by === 'part' ? 'instance' : 'part' });

/** Does nothing if the scene ignores contacts, because the first contact may be ignored. */
export const toggleFirstContact: Change = ({ firstContact, scene }) => ({
  firstContact: !firstContact && scene?.ignore.length === 0,
});
export const checkAllFrames: Change = () => ({ frames: null });
export const toggleTheme: Change = ({ theme }) => ({ theme: isDark(theme) ? 'light' : 'dark' });
export const toggleHelp: Change = ({ isHelpOpen }) => ({ isHelpOpen: !isHelpOpen });

export const toggleWork: Change = ({ isWorkOpen }) => ({ isWorkOpen: !isWorkOpen });
export const toggleCards: Change = ({ areCardsOpen }) => ({ areCardsOpen: !areCardsOpen });

export function filterBy(change: Partial<Filter>): Change {
  return ({ filter }) => ({ filter: { ...filter, ...change } });
}

export const toggleBoxes: Change = (state) =>
  state.boxLevel === null ? toBoxLevel(state.lastBoxLevel)(state) : { boxLevel: null };

/** A level of the deepest tree, and no deeper. */
export function toBoxLevel(level: number): Change {
  return ({ characters }) => {
    const boxLevel = Math.min(level, deepestLevel(characters));
    return { boxLevel, lastBoxLevel: boxLevel };
  };
}

/** Less than the root's level hides the boxes. */
export function changeBoxLevel(by: 1 | -1): Change {
  return (state) => {
    const level = (state.boxLevel ?? -1) + by;
    return level < 0 ? { boxLevel: null } : toBoxLevel(level)(state);
  };
}

export function deepestLevel(characters: readonly CharacterFacts[]): number {
  return Math.max(0, ...characters.map(({ levelCount }) => levelCount - 1));
}

export function select(instance: number | null): Change {
  return () => ({ selected: instance });
}

/** Selects contacts and a frame with such contacts; null deselects. */
export function lookAt(spot: Spot | null, frame?: number): Change {
  return (state) => ({
    spot: spot && { ...spot },
    ...(frame === undefined ? {} : toFrame(frame)(state)),
    ...(spot && { isPlaying: false }),
  });
}

export function moveCamera(move: CameraMove): Change {
  return () => ({ cameraMove: { ...move } });
}

/** Another clip may make the scene longer or shorter. */
export function changeInstance(instance: number, change: Partial<Instance>): Change {
  return edit(`${instance} ${Object.keys(change)}`, ({ scene, characters, frame }) => {
    if (!scene) return {};
    const changed = withInstance(scene, instance, change);
    if (!('clip' in change)) return { scene: changed };
    const whole = inWholeClips(scene, changed, characters);
    return { scene: whole, frame: Math.min(frame, whole.frameCount - 1) };
  });
}

/** Does nothing to the only character. */
export function removeInstance(instance: number): Change {
  return edit(null, ({ scene, characters, opened, frame, hidden, filter }) => {
    if (!scene || scene.instances.length < 2) return {};
    const left = without(scene, instance, characters);
    const remaining = inWholeClips(
      scene,
      opened ? { ...left, name: scene.name } : left,
      characters,
    );
    return {
      scene: remaining,
      frame: Math.min(frame, remaining.frameCount - 1),
      selected: null,
      spot: null,
      filter: { ...filter, pair: null },
      hidden: new Set([...hidden].flatMap((i) => (i === instance ? [] : i > instance ? i - 1 : i))),
    };
  });
}

/** Adds a copy beside the character, and selects it. */
export function duplicateInstance(instance: number): Change {
  return edit(null, ({ scene, characters }) => {
    if (!scene) return {};
    const doubled = duplicated(scene, instance, characters);
    return { scene: doubled, selected: doubled.instances.length - 1 };
  });
}

export function toggleHidden(instance: number): Change {
  return ({ hidden }) => {
    const others = new Set([...hidden].filter((other) => other !== instance));
    return { hidden: hidden.has(instance) ? others : others.add(instance) };
  };
}

export function changeFrameCount(frameCount: number): Change {
  return edit('frames', ({ scene, frame }) => ({
    scene: scene && { ...scene, frameCount },
    frame: Math.min(frame, frameCount - 1),
  }));
}

export function changeFps(fps: number): Change {
  return edit('fps', ({ scene, characters, frame }) => {
    if (!scene) return {};
    const changed = inWholeClips(scene, withFps(scene, fps), characters);
    const sameTime = Math.round((frame * fps) / scene.fps);
    return { scene: changed, frame: Math.min(sameTime, changed.frameCount - 1) };
  });
}

/** Places all characters again. */
export function rearrange(arrangement: State['arrangement']): Change {
  return edit(null, ({ scene, characters, opened }) => {
    if (!scene) return {};
    const placed =
      arrangement === 'opened' ? opened : arrange(characters, arrangement, castOf(scene));
    return {
      arrangement,
      scene: placed,
      arranged: placed,
      frame: 0,
      selected: null,
      spot: null,
      side: null,
      hidden: new Set(),
    };
  });
}

/** Initial state of the stage. */
export interface Beginning {
  frame: number;
  plays: boolean;
  readingOptions: ReadingOptions;
  gizmo: State['gizmo'];
  frames: State['frames'];
}

/** The new characters take the stage. */
export function open(
  { characters, scene, refused }: Opened,
  {
    frame = 0,
    plays = true,
    readingOptions = {},
    gizmo = 'move',
    frames = null,
  }: Partial<Beginning> = {},
): Change {
  return ({ boxLevel, firstContact }) => {
    const placed = scene ?? arrange(characters, USUAL_ARRANGEMENT);
    return {
      characters,
      readingOptions,
      scene: placed,
      opened: scene,
      firstContact: firstContact && !scene?.ignore.length,
      arrangement: scene ? 'opened' : USUAL_ARRANGEMENT,
      arranged: placed,
      reading: null,
      frame,
      frames,
      isPlaying: plays && !wantsStillness(),
      past: [],
      future: [],
      hidden: new Set(),
      filter: NO_FILTER,
      selected: null,
      gizmo,
      spot: null,
      side: null,
      boxLevel: boxLevel && Math.min(boxLevel, deepestLevel(characters)),
      answer: null,
      costs: null,
      hovered: null,
      problems: refused.map(problemOf),
    };
  };
}

/** The new characters join those on the stage, the last of them to be placed. */
export function add({ characters: added, refused }: ReadCharacters): Change {
  return edit(null, (state) => {
    const { scene, opened, characters: present, arrangement, arranged, problems } = state;
    const characters = [...present, ...added];
    const joinAll = (begin: Scene) =>
      added.reduce((all, _, i) => join(all, characters, present.length + i, arrangement), begin);
    const joined = scene && joinAll(opened ? scene : withoutDouble(scene));
    return {
      characters,
      scene: joined,
      arranged: scene === arranged ? joined : arranged,
      opened: opened && joinAll(opened),
      reading: null,
      selected: joined && joined.instances.length - 1,
      spot: null,
      side: null,
      problems: [...problems, ...refused.map(problemOf)],
    };
  });
}

/** A character that was dropped alone has met itself only for want of others. */
function withoutDouble(scene: Scene): Scene {
  return meetsItself(scene) ? { ...scene, instances: scene.instances.slice(0, 1) } : scene;
}

function problemOf({ path, message }: Refusal): Problem {
  return { title: `${path} was left out`, message };
}

/** Adds a problem. Leaves the scene unchanged, and does not repeat a visible problem. */
export function refuse(
  title: string,
  message: string,
  remedy: Problem['remedy'] = undefined,
): Change {
  return ({ problems }) => {
    const others = problems.filter((problem) => problem.message !== message);
    return { problems: [...others, { title, message, ...(remedy && { remedy }) }] };
  };
}

/** Adds remedies to the problems that have one. */
export function offerRemedies(remedyFor: (message: string) => Problem['remedy']): Change {
  return ({ problems }) => ({
    problems: problems.map((problem) => {
      const remedy = remedyFor(problem.message);
      return remedy ? { ...problem, remedy } : problem;
    }),
  });
}

export function dismiss(problem: Problem): Change {
  return ({ problems }) => ({ problems: problems.filter((other) => other !== problem) });
}

/** Progress of a sweep that has been given up is passed over. */
export function sweepOn({ id, counts, total }: SweepProgress): Change {
  return (state) => {
    if (id !== state.sweep.id) return {};
    const sweep = { id, counts: [...state.sweep.counts, ...counts], total };
    return { sweep, finding: state.finding ?? findingOf({ ...state, sweep }) };
  };
}
