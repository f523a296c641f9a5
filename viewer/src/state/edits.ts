/** Changes of the scene, all of which can be undone. */

import { arrange, join, type Arrangement } from '../scene/arrange';
import { castOf, duplicated, without } from '../scene/cast';
import { inWholeClips, withFps, withInstance } from '../scene/scene';
import type { Instance, Scene } from '../scene/types';
import type { ReadCharacters } from '../worker/protocol';
import { problemOf } from './changes';
import { edit } from './history';
import type { Change, State } from './state';

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

/**
 * The new characters join those on the stage, the last of them to be placed. A character that stood
 * there alone is placed with them, unless it was edited.
 */
export function add({ characters: added, refused }: ReadCharacters): Change {
  return edit(null, (state) => {
    const { scene, opened, characters: present, arrangement, arranged, problems } = state;
    const characters = [...present, ...added];
    const joinAll = (begin: Scene) =>
      added.reduce((all, _, i) => join(all, characters, present.length + i, arrangement), begin);
    const isPlaced = scene !== arranged || opened !== null || scene?.instances.length !== 1;
    const joined =
      scene && (isPlaced ? joinAll(scene) : arrange(characters, arrangement as Arrangement));
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
