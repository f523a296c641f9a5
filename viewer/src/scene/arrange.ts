/** Where characters stand that came without a scene: on a circle, walking towards its middle. */

import type { CharacterFacts } from '../worker/protocol';
import type { Instance, Scene } from './scene';

const FPS = 60;
const SECONDS = 3;

/** Shares of the characters' size: how far from the middle they start, and how far beside it
 * they pass each other. */
const RADIUS = 0.75;
const SIDESTEP = 0.1;

/** A single character meets itself. */
export function arrange(characters: readonly CharacterFacts[]): Scene {
  const cast = characters.length === 1 ? [0, 0] : characters.map((_, index) => index);
  const size = Math.max(...characters.map(sizeOf));
  return {
    name: characters.map((character) => character.name).join(', '),
    frameCount: FPS * SECONDS,
    fps: FPS,
    instances: cast.map((character, index) =>
      walkIn(characters[character], character, (2 * Math.PI * index) / cast.length, size),
    ),
  };
}

/** Their height, or length from front to back. */
function sizeOf({ extent: { low, high } }: CharacterFacts): number {
  return Math.max(high[1] - low[1], high[2] - low[2]) || 1;
}

/** They face +z, and start where that leads to the middle; the walk takes two thirds of the time. */
function walkIn(facts: CharacterFacts, character: number, turn: number, size: number): Instance {
  const [sin, cos] = [Math.sin(turn), Math.cos(turn)];
  const speed = (1.5 * RADIUS * size) / SECONDS;
  const [ahead, aside] = [-RADIUS * size, SIDESTEP * size];
  return {
    character,
    clip: chooseClip(facts),
    start: 0,
    speed: 1,
    translation: [sin * ahead + cos * aside, 0, cos * ahead - sin * aside],
    rotation: [0, Math.sin(turn / 2), 0, Math.cos(turn / 2)],
    scale: 1,
    velocity: [sin * speed, 0, cos * speed],
    morphWeights: {},
  };
}

function chooseClip({ clips }: CharacterFacts): string | null {
  const walk = clips.find((clip) => /walk/i.test(clip.name));
  return (walk ?? clips[0])?.name ?? null;
}
