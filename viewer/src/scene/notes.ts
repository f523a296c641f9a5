/** Notes about choices of the page for characters without a scene. */

import type { CharacterFacts } from '../worker/protocol';
import { chooseClip, sizeOf } from './arrange';
import type { Scene } from './types';

/** Returns the notes that currently apply. */
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
