import { Component, type ComponentChildren, type FunctionComponent } from 'preact';

/** A component that rerenders only when one of its properties changes. */
export function memo<Props extends object>(render: FunctionComponent<Props>) {
  return class extends Component<Props> {
    override shouldComponentUpdate(next: Readonly<Props>): boolean {
      return Object.entries(next).some(
        ([name, value]) => value !== this.props[name as keyof Props],
      );
    }

    override render(): ComponentChildren {
      return render(this.props);
    }
  };
}
