import { Component, h, type ComponentChildren, type FunctionComponent } from 'preact';
import type { State } from '../state/state';

interface Watching {
  state: State;
}

/**
 * A panel that is rendered only after a change of state that it has read: frames change sixty times
 * per second, and most panels do not show them.
 */
export function watch<Props extends Watching>(panel: FunctionComponent<Props>) {
  return class extends Component<Props> {
    private readonly read = new Set<keyof State>();

    override shouldComponentUpdate(next: Readonly<Props>): boolean {
      return [...this.read].some((fact) => next.state[fact] !== this.props.state[fact]);
    }

    override render(): ComponentChildren {
      return h(panel, { ...this.props, state: noting(this.props.state, this.read) });
    }
  };
}

/** The state, and a note of each fact of it that is read. */
function noting(state: State, read: Set<keyof State>): State {
  return new Proxy(state, {
    get(facts, fact: keyof State) {
      read.add(fact);
      return facts[fact];
    },
  });
}
