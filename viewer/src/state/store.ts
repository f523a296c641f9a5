/** Holds the changing state. Listeners are called once per turn, not once per change. */
export class Store<State> {
  private readonly listeners: ((state: State, before: State) => void)[] = [];
  private told: State;

  constructor(private current: State) {
    this.told = current;
  }

  get state(): State {
    return this.current;
  }

  readonly update = (change: (state: State) => Partial<State>): void => {
    const isPending = this.current !== this.told;
    this.current = { ...this.current, ...change(this.current) };
    if (!isPending) queueMicrotask(() => this.tell());
  };

  listen(listener: (state: State, before: State) => void): void {
    this.listeners.push(listener);
  }

  private tell(): void {
    const before = this.told;
    this.told = this.current;
    for (const listener of this.listeners) listener(this.told, before);
  }
}
