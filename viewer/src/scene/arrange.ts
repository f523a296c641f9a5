/** Placement of characters without a scene. */

import type { CharacterFacts } from '../worker/protocol';
import { castOf, nameOf } from './cast';
import { framesOfLongestClip, inWholeClips, placeAt } from './scene';
import type { Instance, Scene, Vector3 } from './types';

/**
 * `walking`: on a circle, towards its middle.
 * `together`: all in the same place, as `pelt check A.glb B.glb` has them: a body and its coat.
 */
export type Arrangement = 'walking' | 'together';

/** Whole characters in one place would touch everywhere. */
export const USUAL_ARRANGEMENT: Arrangement = 'walking';

/** Frame rate of the command. */
export const FPS = 30;

/** A walk takes at least so long, however short the clip. */
const SECONDS = 3;

/** Distance from the middle at which they start, in sizes of the largest character. */
const RADIUS = 0.75;
/** Distance from the middle at which they pass it, in widths of the narrowest: so they all meet. */
const SIDESTEP = 0.1;

/** Share of the time in which the middle is reached. */
const MEETING = 2 / 3;

/** Distance of neighbours on the circle, in widths. */
const SPACING = 1.2;

/**
 * Creates a scene with the length of the longest clip. `cast` has the number of the character of
 * each instance; by default, each character appears once.
 */
export function arrange(
  characters: readonly CharacterFacts[],
  arrangement: Arrangement,
  cast: readonly number[] = [...characters.keys()],
): Scene {
  const standing: Scene = {
    name: nameOf(cast, characters),
    frameCount: 1,
    fps: FPS,
    ignore: [],
    instances: cast.map((character) => stand(characters[character], character)),
  };
  const frameCount = framesOfLongestClip(standing, characters);
  if (arrangement === 'together' || cast.length === 1) return { ...standing, frameCount };
  return walkingIn({ ...standing, frameCount: Math.max(frameCount, FPS * SECONDS) }, characters);
}

/** Places one more character: in the same place, or walking towards the others. */
export function join(
  scene: Scene,
  characters: readonly CharacterFacts[],
  character: number,
  arrangement: Arrangement | 'opened',
): Scene {
  const comes = arrangement !== 'together' && scene.frameCount > 1;
  const instance = {
    ...stand(characters[character], character),
  };
  const name = `${scene.name}, ${characters[character].name}`;
  const joined = { ...scene, name, instances: [...scene.instances, instance] };
  if (comes) Object.assign(instance, walkTo(meetingPlace(scene), joined, characters));
  return inWholeClips(scene, joined, characters);
}

/** The middle of all at the time when those who walk in have come there. */
function meetingPlace(scene: Scene): Vector3 {
  const time = (MEETING * scene.frameCount) / scene.fps;
  const places = scene.instances.map((instance) => placeAt(instance, time));
  return [0, 1, 2].map(
    (axis) => places.reduce((sum, place) => sum + place[axis], 0) / places.length,
  ) as Vector3;
}

/** For the last instance of a scene. Direction between the others: 1/2, 1/4, 3/4, 1/8, 5/8 ... of a full turn. */
function walkTo(
  middle: Vector3,
  scene: Scene,
  characters: readonly CharacterFacts[],
): Partial<Instance> {
  const cast = castOf(scene).map((character) => characters[character]);
  const radius = RADIUS * Math.max(...cast.map(sizeOf));
  const walk = { radius, aside: sidestepOf(cast), speed: speedOf(radius, scene) };
  const walked = walkIn(2 * Math.PI * shareOfTurn(scene.instances.length - 1), walk);
  const translation = walked.translation.map((value, axis) => value + middle[axis]);
  return { ...walked, translation: translation as Vector3 };
}

/** The digits of the number in base 2, mirrored at the point. */
function shareOfTurn(number: number): number {
  return number === 0 ? 0 : (number % 2) / 2 + shareOfTurn(Math.floor(number / 2)) / 2;
}

function stand(facts: CharacterFacts, character: number): Instance {
  return {
    character,
    clip: chooseClip(facts),
    start: 0,
    speed: 1,
    translation: [0, 0, 0],
    rotation: [0, 0, 0, 1],
    scale: 1,
    velocity: [0, 0, 0],
    morphWeights: {},
  };
}

export function chooseClip({ clips }: CharacterFacts): string | null {
  const walk = clips.find((clip) => /walk/i.test(clip.name));
  return (walk ?? clips[0])?.name ?? null;
}

function walkingIn(scene: Scene, characters: readonly CharacterFacts[]): Scene {
  const count = scene.instances.length;
  const cast = castOf(scene).map((character) => characters[character]);
  const spacing = SPACING * Math.max(...cast.map(widthOf));
  const size = Math.max(...cast.map(sizeOf));
  const radius = Math.max(RADIUS * size, spacing / (2 * Math.sin(Math.PI / count)));
  const walk = { radius, aside: sidestepOf(cast), speed: speedOf(radius, scene) };
  return {
    ...scene,
    instances: scene.instances.map((instance, index) => ({
      ...instance,
      ...walkIn((2 * Math.PI * index) / count, walk),
    })),
  };
}

/** Height, or length from front to back. */
export function sizeOf({ extent: { low, high } }: CharacterFacts): number {
  return Math.max(high[1] - low[1], high[2] - low[2]) || 1;
}

function sidestepOf(cast: readonly CharacterFacts[]): number {
  return SIDESTEP * Math.min(...cast.map(widthOf));
}

function widthOf({ extent: { low, high } }: CharacterFacts): number {
  return high[0] - low[0];
}

interface Walk {
  radius: number;
  aside: number;
  speed: number;
}

function speedOf(radius: number, { frameCount, fps }: Scene): number {
  return (radius * fps) / (MEETING * frameCount);
}

/** They face +z, and start where that leads to the middle. */
function walkIn(
  turn: number,
  { radius, aside, speed }: Walk,
): Pick<Instance, 'translation' | 'rotation' | 'velocity'> {
  const [sin, cos] = [Math.sin(turn), Math.cos(turn)];
  return {
    translation: [-sin * radius + cos * aside, 0, -cos * radius - sin * aside],
    rotation: [0, Math.sin(turn / 2), 0, Math.cos(turn / 2)],
    velocity: [sin * speed, 0, cos * speed],
  };
}

/** Returns the notes about choices of the page for characters without a scene, as far as they apply. */
export function notesOn(scene: Scene, characters: readonly CharacterFacts[]): string[] {
  const notes = [];
  const sizes = sizesApart(scene, characters);
  if (sizes) notes.push(sizes);
  if (playsChosenClips(scene, characters)) {
    const clips = clipsInWords(scene);
    notes.push(`Clips chosen by the page: ${clips}. The command plays a clip only with --clip.`);
  }
  return notes;
}

/** Ratio of sizes from which characters hardly meet. */
const FAR_APART = 5;

/** A note if one character is many times as large as another, as in files of different units. */
function sizesApart({ instances }: Scene, characters: readonly CharacterFacts[]): string | null {
  const sizes = instances.map(({ character, scale }) => scale * sizeOf(characters[character]));
  const [most, least] = [Math.max(...sizes), Math.min(...sizes)];
  if (most < FAR_APART * least) return null;
  const nameOf = (size: number) => characters[instances[sizes.indexOf(size)].character].name;
  const times = Math.round(most / least);
  return `${nameOf(most)} is ${times} times as large as ${nameOf(least)}: change “scale” on a card.`;
}

function playsChosenClips({ instances }: Scene, characters: readonly CharacterFacts[]): boolean {
  return (
    characters.some(({ clips }) => clips.length > 0) &&
    instances.every(({ character, clip }) => clip === chooseClip(characters[character]))
  );
}

/** Each once. */
function clipsInWords({ instances }: Scene): string {
  const names = new Set(
    instances.map(({ clip }) => (clip === null ? 'the default pose' : `“${clip || 'unnamed'}”`)),
  );
  return [...names].join(', ');
}
