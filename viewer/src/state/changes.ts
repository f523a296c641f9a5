/**
 * Changes of the state, one function for each action of the user. Those of the scene are in
 * `edits.ts`.
 */

import { sceneOfClip } from '../report/clips';
import { asksBetween, budgetOf, clearanceOf, type ClipReport, type Report } from '../report/report';
import { findingOf, framesToCheck, worstFrame } from '../report/verdict';
import { arrange, USUAL_ARRANGEMENT } from '../scene/arrange';
import { wantedSelf } from '../scene/self';
import type { SelfChoices } from '../scene/types';
import { isDark, wantsStillness } from '../theme';
import type {
  CharacterFacts,
  Moment,
  Opened,
  ReadingOptions,
  Refusal,
  Spot,
  SweepProgress,
} from '../worker/protocol';
import { momentOf } from './shots';
import {
  NO_FILTER,
  type CameraMove,
  type Change,
  type Filter,
  type Problem,
  type State,
} from './state';
import { knownSteps } from './steps';

/** Frames follow each other in a circle. */
export function toFrame(frame: number): Change {
  return ({ scene }) => {
    const count = scene?.frameCount ?? 1;
    return { frame: ((frame % count) + count) % count, moment: null };
  };
}

/** Goes to a frame and pauses. */
export function pauseAt(frame: number): Change {
  return (state) => ({ ...toFrame(frame)(state), isPlaying: false });
}

/** Goes to a time after a frame and pauses. */
export function pauseBetween(frame: number, moment: Moment): Change {
  return ({ scene }) => ({
    ...(scene && { moment: { scene, frame, moment: { ...moment } } }),
    frame,
    spot: null,
    isPlaying: false,
  });
}

/** Steps stop what plays. */
export function step(frames: number): Change {
  return (state) => pauseAt(state.frame + frames)(state);
}

/**
 * Jumps to the nearest start of a range of frames in contact, forwards or backwards, or to the first
 * contact of a step that begins without contact.
 */
export function jumpToContact(direction: 1 | -1): Change {
  return (state) => {
    const next = nextStart(startsOfContact(state), timeOf(state), direction);
    if (!next) return {};
    const { frame, moment } = next;
    return (moment ? pauseBetween(frame, moment) : pauseAt(frame))(state);
  };
}

/** A frame, or a time after it. */
type Start = { frame: number; moment: Moment | null };

function startsOfContact(state: State): Start[] {
  const { counts } = state.sweep;
  const frames = counts.flatMap((count, frame) => (count && !counts[frame - 1] ? [frame] : []));
  const steps = (knownSteps(state) ?? []).filter(({ frame }) => !counts[frame]);
  return [
    ...frames.map((frame) => ({ frame, moment: null })),
    ...steps.map(({ frame, first }) => ({ frame, moment: first })),
  ].sort((one, other) => timeAt(one) - timeAt(other));
}

/** Time in frames. */
function timeAt({ frame, moment }: Start): number {
  return moment ? frame + moment.share * (moment.to - frame) : frame;
}

function timeOf(state: State): number {
  return timeAt({ frame: state.frame, moment: momentOf(state) });
}

/** Returns the next start, cyclically; nothing without contacts. `starts` ascend. */
function nextStart(starts: readonly Start[], from: number, direction: 1 | -1): Start | undefined {
  if (direction > 0) return starts.find((start) => timeAt(start) > from) ?? starts[0];
  return starts.findLast((start) => timeAt(start) < from) ?? starts.at(-1);
}

export const togglePlaying: Change = ({ isPlaying }) => ({ isPlaying: !isPlaying });
export const toggleBetween: Change = ({ between }) => ({ between: !between });
export const toggleBy: Change = ({ by }) => ({ by: by === 'part' ? 'instance' : 'part' });

export const toggleLimit: Change = (state) =>
  state.maxContacts === null ? limitContacts(state.lastMaxContacts)(state) : { maxContacts: null };

/**
 * Does nothing if the scene ignores contacts, because the first contacts may be ignored, or with a
 * budget.
 */
export function limitContacts(maxContacts: number): Change {
  return ({ scene, budget }) =>
    scene?.ignore.length === 0 && budget === null
      ? { maxContacts, lastMaxContacts: maxContacts }
      : {};
}

export function chooseSelf(change: SelfChoices): Change {
  return ({ self }) => ({ self: { ...self, ...change }, spot: null });
}

/** Off, or on; not for distances, which are between different bodies, and not with a budget. */
export const toggleSelf: Change = (state) => {
  if (!state.scene || state.clearance !== null || state.budget !== null) return {};
  const isOff = wantedSelf({ ...state, scene: state.scene }) === 'off';
  return chooseSelf({ wanted: isOff ? 'also' : 'off' })(state);
};

export const toggleSelfFilters: Change = ({ areSelfFiltersOpen }) => ({
  areSelfFiltersOpen: !areSelfFiltersOpen,
});

/** Finds all contacts, however much work that is. */
export const decideAll: Change = () => ({ budget: null });
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

export function toggleHidden(instance: number): Change {
  return ({ hidden }) => {
    const others = new Set([...hidden].filter((other) => other !== instance));
    return { hidden: hidden.has(instance) ? others : others.add(instance) };
  };
}

/** Initial state of the stage. */
export interface Beginning {
  frame: number;
  plays: boolean;
  readingOptions: ReadingOptions;
  gizmo: State['gizmo'];
  frames: State['frames'];
  clearance: State['clearance'];
  budget: State['budget'];
}

/** The new characters take the stage. */
export function open(
  { characters, scene, self, refused }: Opened,
  {
    frame = 0,
    plays = true,
    readingOptions = {},
    gizmo = 'move',
    frames = null,
    clearance = null,
    budget = null,
  }: Partial<Beginning> = {},
): Change {
  return ({ boxLevel, maxContacts }) => {
    const placed = scene ?? arrange(characters, USUAL_ARRANGEMENT);
    return {
      characters,
      readingOptions,
      self,
      scene: placed,
      opened: scene,
      maxContacts: scene?.ignore.length ? null : maxContacts,
      arrangement: scene ? 'opened' : USUAL_ARRANGEMENT,
      arranged: placed,
      reading: null,
      frame,
      frames,
      clearance,
      budget,
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

/** Opens the scene of a report, paused at its worst frame if it has contacts. */
export function openReported(opened: Opened, report: Report): Change {
  const { reading, answer } = report;
  const worst = answer && worstFrame(answer);
  const openScene = open(opened, {
    ...(worst && { frame: worst.frame, plays: false }),
    readingOptions: reading,
    gizmo: null, // otherwise a click could lead to a move by accident
    frames: answer && framesToCheck(answer, opened.scene),
    clearance: clearanceOf(report),
    budget: budgetOf(report),
  });
  return (state) => ({
    ...openScene(state),
    between: asksBetween(report),
    report,
    reported: opened.scene,
    finding: null,
  });
}

/** Whether the clips of the report can be chosen: its characters are still on the stage. */
export function canChooseClip({ reel, reported, opened }: State): boolean {
  return reel !== null && reported !== null && opened === reported;
}

/** Shows another clip of a report of all clips. The query stays as the user has chosen it. */
export function chooseClip(clip: ClipReport): Change {
  return (state) => {
    const { reel, reported, characters, self } = state;
    if (!reel || !reported || !canChooseClip(state)) return {};
    const scene = sceneOfClip(reported, clip, reel);
    return openReported({ characters, scene, self, refused: [] }, clip.report)(state);
  };
}

export function problemOf({ path, message }: Refusal): Problem {
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
export function sweepOn(progress: SweepProgress): Change {
  const { id, searched, counts, selfCounts, undecided, steps, total } = progress;
  return (state) => {
    if (id !== state.sweep.id) return {};
    const sweep = {
      id,
      searched,
      counts: [...state.sweep.counts, ...counts],
      selfCounts: [...state.sweep.selfCounts, ...selfCounts],
      undecided: [...state.sweep.undecided, ...undecided],
      steps: [...state.sweep.steps, ...steps],
      total,
    };
    return { sweep, finding: state.finding ?? findingOf({ ...state, sweep }) };
  };
}
