import type { State, Update } from '../state/state';

/** What every panel is given. */
export interface PanelProps {
  state: State;
  update: Update;
}
