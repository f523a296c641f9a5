/** Where characters stand that came without a scene: on a circle, walking towards its middle. */

import type { CharacterFacts } from '../worker/protocol';
import type { Instance, Scene } from './scene';

const FPS = 60;
const SECONDS = 3;

/** Shares of the characters' height: how far from the middle they start, and how far beside it
 * they pass each other. */
const RADIUS = 0.75;
const SIDESTEP = 0.1;

/** A single character meets itself. */
export function arrange(characters: readonly CharacterFacts[]): Scene {
  const cast = characters.length === 1 ? [0, 0] : characters.map((_, index) => index);
  const height = Math.max(...characters.map(heightOf));
  return {
    name: characters.map((character) => character.name).join(', '),
    frameCount: FPS * SECONDS,
    fps: FPS,
    instances: cast.map((character, index) =>
      walkIn(characters[character], character, (2 * Math.PI * index) / cast.length, height),
    ),
  };
}

function heightOf({ extent }: CharacterFacts): number {
  return extent.high[1] - extent.low[1] || 1;
}

/** They face +z, and start where that leads to the middle; the walk takes two thirds of the time. */
function walkIn(facts: CharacterFacts, character: number, turn: number, height: number): Instance {
  const [sin, cos] = [Math.sin(turn), Math.cos(turn)];
  const speed = (1.5 * RADIUS * height) / SECONDS;
  const [ahead, aside] = [-RADIUS * height, SIDESTEP * height];
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
