import { isAsItCame } from '../report/verdict';
import { checkCommand, sceneFile } from '../scene/command';
import { checkedFrames } from '../state/frames';
import type { State } from '../state/state';
import { asksBetween } from '../state/steps';

/** Shows the command with the same result. An unmodified report shows its own command. */
export function SameNumbers({ state }: { state: State }) {
  const { scene, report } = state;
  if (!scene || (report?.answer && isAsItCame(state))) return null;
  const { words, needsFile } = checkCommand({
    ...state,
    scene,
    between: asksBetween(state),
    frames: checkedFrames(state),
  });
  return (
    <p class="same quiet">
      Same result: <code>{words}</code>
      {needsFile && (
        <>
          {' with the '}
          <button class="link" onClick={() => saveScene(state)}>
            saved scene
          </button>
        </>
      )}
    </p>
  );
}

/** Lets the browser save the scene on the stage as a file. */
export function saveScene({ scene, characters, self }: State): void {
  if (!scene) return;
  const link = document.createElement('a');
  link.href = `data:application/json,${encodeURIComponent(sceneFile(scene, characters, self))}`;
  link.download = 'scene.json';
  link.click();
}
