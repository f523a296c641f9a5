import { HEAD } from '../flow/painted';
import { toggleHelp, toggleTheme } from '../state/changes';
import { undo } from '../state/history';
import type { PanelProps } from './panel_props';
import { saveScene } from './same_numbers';

export function Header({ state, update, openFiles }: PanelProps & { openFiles: () => void }) {
  const { scene, reading, past } = state;
  return (
    <header class="head">
      <h1 {...{ elementtiming: HEAD }}>Pelt</h1>
      <p class="subject" aria-live="polite" title={scene?.name}>
        {reading ? `reading ${reading} …` : scene?.name}
      </p>
      <nav>
        <button onClick={openFiles} title="Open .glb files, or drop them anywhere">
          Open files
        </button>
        <button
          disabled={!scene}
          onClick={() => saveScene(state)}
          title="Save the scene; `pelt check` gives the same numbers for it"
        >
          Save scene
        </button>
        <button
          disabled={past.length === 0}
          onClick={() => update(undo)}
          title="Undo the last change of the scene (Ctrl+Z)"
        >
          Undo
        </button>
        <button
          onClick={() => update(toggleTheme)}
          title="Dark or light (T)"
          aria-label="Dark or light"
        >
          ◐
        </button>
        <button onClick={() => update(toggleHelp)} title="Help (?)" aria-label="Help">
          ?
        </button>
      </nav>
    </header>
  );
}
