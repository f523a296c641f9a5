/** Where characters stand that came without a scene. */

import type { CharacterFacts } from '../worker/protocol';
import { framesOfLongestClip, type Instance, type Scene } from './scene';

/**
 * `together`: all in the same place, as `pelt check A.glb B.glb` has them: a body and its coat.
 * `walking`: on a circle, towards its middle.
 */
export type Arrangement = 'together' | 'walking';

/** That of the command. */
const FPS = 30;

/** A walk takes at least so long, however short the clip. */
const SECONDS = 3;

/** Shares of the characters' size: how far from the middle they start, and how far beside it
 * they pass each other. */
const RADIUS = 0.75;
const SIDESTEP = 0.1;

/** From one to the next on the circle, in widths. */
const SPACING = 1.2;

/** A single one walks into itself: in the same place, everything would touch. */
export function usualArrangement(characters: readonly CharacterFacts[]): Arrangement {
  return characters.length === 1 ? 'walking' : 'together';
}

/** As long as the longest clip. A single character meets itself. */
export function arrange(characters: readonly CharacterFacts[], arrangement: Arrangement): Scene {
  const cast = characters.length === 1 ? [0, 0] : characters.map((_, index) => index);
  const standing: Scene = {
    name: characters.map((character) => character.name).join(', '),
    frameCount: 1,
    fps: FPS,
    ignore: [],
    instances: cast.map((character) => stand(characters[character], character)),
  };
  const frameCount = framesOfLongestClip(standing, characters);
  if (arrangement === 'together') return { ...standing, frameCount };
  return walkingIn({ ...standing, frameCount: Math.max(frameCount, FPS * SECONDS) }, characters);
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

function chooseClip({ clips }: CharacterFacts): string | null {
  const walk = clips.find((clip) => /walk/i.test(clip.name));
  return (walk ?? clips[0])?.name ?? null;
}

function walkingIn(scene: Scene, characters: readonly CharacterFacts[]): Scene {
  const size = Math.max(...characters.map(sizeOf));
  const count = scene.instances.length;
  const spacing = SPACING * Math.max(...characters.map(widthOf));
  const radius = Math.max(RADIUS * size, spacing / (2 * Math.sin(Math.PI / count)));
  const speed = (1.5 * radius * scene.fps) / scene.frameCount;
  const walk = { radius, aside: SIDESTEP * size, speed };
  return {
    ...scene,
    instances: scene.instances.map((instance, index) => ({
      ...instance,
      ...walkIn((2 * Math.PI * index) / count, walk),
    })),
  };
}

/** Their height, or length from front to back. */
function sizeOf({ extent: { low, high } }: CharacterFacts): number {
  return Math.max(high[1] - low[1], high[2] - low[2]) || 1;
}

function widthOf({ extent: { low, high } }: CharacterFacts): number {
  return high[0] - low[0];
}

interface Walk {
  radius: number;
  aside: number;
  speed: number;
}

/** They face +z, and start where that leads to the middle; the walk takes two thirds of the time. */
function walkIn(turn: number, { radius, aside, speed }: Walk): Partial<Instance> {
  const [sin, cos] = [Math.sin(turn), Math.cos(turn)];
  return {
    translation: [-sin * radius + cos * aside, 0, -cos * radius - sin * aside],
    rotation: [0, Math.sin(turn / 2), 0, Math.cos(turn / 2)],
    velocity: [sin * speed, 0, cos * speed],
  };
}
