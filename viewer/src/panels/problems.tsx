import { dismiss } from '../state/changes';
import type { PanelProps } from './panel_props';

export function Problems({ state: { problems }, update }: PanelProps) {
  return (
    <div class="problems" role="alert">
      {problems.map((problem) => (
        <div class="problem">
          <strong>{problem.title}</strong>
          <p>{problem.message}</p>
          <button aria-label="Dismiss" onClick={() => update(dismiss(problem))}>
            ×
          </button>
        </div>
      ))}
    </div>
  );
}
