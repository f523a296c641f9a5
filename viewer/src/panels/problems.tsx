import { dismiss } from '../state/changes';
import type { PanelProps } from './panel_props';

export function Problems({ state: { problems }, update }: PanelProps) {
  return (
    <div class="problems" role="alert">
      {problems.map((problem) => (
        <div class="problem">
          <strong>{problem.title}</strong>
          <p>{inWordsOfPage(problem.message)}</p>
          {problem.remedy && (
            <button
              class="remedy"
              onClick={() => (update(dismiss(problem)), problem.remedy!.act())}
            >
              {problem.remedy.label}
            </button>
          )}
          <button class="dismiss" aria-label="Dismiss" onClick={() => update(dismiss(problem))}>
            ×
          </button>
        </div>
      ))}
    </div>
  );
}

/** Without the option of the engine, which the page offers as a button. */
function inWordsOfPage(message: string): string {
  return message.replace(/ \(renormalise: true [^)]*\)/, '');
}
