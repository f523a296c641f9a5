import type { State, Update } from '../state/state';

/** Properties of every panel. */
export interface PanelProps {
  state: State;
  update: Update;
}
