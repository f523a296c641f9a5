import { isAsItCame } from '../report/verdict';
import { checkCommand } from '../scene/command';
import { checkedFrames } from '../state/frames';
import { asksBetween } from '../state/steps';
import type { State } from '../state/state';
import { saveScene } from './save';

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
