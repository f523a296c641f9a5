/** Tells how long something takes that is done bit by bit, with other things in between. */
export class Stopwatch {
  private before = 0;
  private since = 0;

  start(): void {
    this.before = 0;
    this.since = performance.now();
  }

  pause(): void {
    this.before = this.milliseconds;
  }

  goOn(): void {
    this.since = performance.now();
  }

  get milliseconds(): number {
    return this.before + performance.now() - this.since;
  }
}
