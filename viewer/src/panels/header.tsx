import { sceneFile } from '../scene/scene_file';
import { toggleHelp, toggleTheme } from '../state/changes';
import type { PanelProps } from './panel_props';
import { save } from './save';

export function Header({ state, update, openFiles }: PanelProps & { openFiles: () => void }) {
  const { scene, characters, reading } = state;
  return (
    <header class="head">
      <h1>Pelt</h1>
      <p class="subject" aria-live="polite">
        {reading ? `reading ${reading} …` : scene?.name}
      </p>
      <nav>
        <button onClick={openFiles} title="Open .glb files, or drop them anywhere">
          Open files
        </button>
        <button
          disabled={!scene}
          onClick={() => save('scene.json', sceneFile(scene!, characters))}
          title="Save the scene for `pelt check`, which gives the same numbers"
        >
          Save scene
        </button>
        <button
          onClick={() => update(toggleTheme)}
          title="Dark or light (T)"
          aria-label="Dark or light"
        >
          ◐
        </button>
        <button onClick={() => update(toggleHelp)} title="Keys (?)" aria-label="Keys">
          ?
        </button>
      </nav>
    </header>
  );
}
