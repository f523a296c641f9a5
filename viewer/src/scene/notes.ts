/** Notes about choices of the page for characters without a scene. */

import type { CharacterFacts } from '../worker/protocol';
import { chooseClip } from './arrange';
import type { Scene } from './scene';

/** Whether a single character appears twice. */
export function meetsItself({ instances }: Scene): boolean {
  return instances.length === 2 && instances[0].character === instances[1].character;
}

/** Returns the notes that currently apply. */
export function notesOn(scene: Scene, characters: readonly CharacterFacts[]): string[] {
  const notes = [];
  if (meetsItself(scene)) {
    notes.push('A single character meets itself: 1 is a copy of 0 until you add another one.');
  }
  if (playsChosenClips(scene, characters)) {
    const clips = clipsInWords(scene);
    notes.push(`Clips chosen by the page: ${clips}. The command plays a clip only with --clip.`);
  }
  return notes;
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
