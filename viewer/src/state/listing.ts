/** The contacts that are listed: of a frame or of the clip, without those that a filter leaves out. */

import { standingOf } from '../report/baseline';
import type { By, CharacterFacts, Spot, Surface, Touch } from '../worker/protocol';
import type { State } from './state';

/** Whether a place touches its own body: the same instance or, by parts, the same part. */
export function isOfSelf({ a, b }: Spot, by: By): boolean {
  return a.instance === b.instance && (by === 'instance' || a.part === b.part);
}

/** Returns undefined as long as the contacts are not known. */
export function listedTouches({ listing, sweep, answer }: State): readonly Touch[] | undefined {
  return listing === 'clip' ? sweep.total?.touches : answer?.touches;
}

export function filtered(touches: readonly Touch[], state: State): readonly Touch[] {
  const { words, pair, standing } = state.filter;
  if (words === '' && !pair && !standing) return touches;
  return touches.filter(
    (touch) =>
      (!pair || (touch.a.instance === pair[0] && touch.b.instance === pair[1])) &&
      (!standing || standingOf(touch, state) === standing) &&
      matches(words, namesOf(touch, state)),
  );
}

export function matches(words: string, names: string): boolean {
  const wanted = words.toLowerCase().split(/\s+/);
  return wanted.every((word) => names.toLowerCase().includes(word));
}

function namesOf({ a, b }: Spot, { scene, characters }: State): string {
  const nameOf = ({ instance, part, joint }: Surface) => {
    const character: CharacterFacts | undefined =
      characters[scene?.instances[instance]?.character ?? -1];
    return `${instance} ${character?.name} ${part} ${joint}`;
  };
  return `${nameOf(a)} ${nameOf(b)}`;
}
