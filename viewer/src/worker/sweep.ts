/** Counts the contacts of every checked frame in the background, a few milliseconds at a time. */

import type { ContactHash, Pelt, Scene as EngineScene } from 'pelt';
import type { FrameRange, Questions, SweepProgress, SweepTotal } from './protocol';
import { SceneCrowd } from './scene_crowd';
import { TouchTally } from './touches';

/** Longest time that counting may delay a requested frame. */
const SLICE_MILLISECONDS = 6;

const REPORT_MILLISECONDS = 100;

export class Sweep {
  /** Settled when all is counted or given up, rejected when a frame cannot be. */
  readonly ended: Promise<null>;
  private readonly crowd: SceneCrowd;
  private readonly hash: ContactHash;
  private readonly tally: TouchTally;
  private next = 0;
  private ignored = 0;
  /** Counts not reported yet, and the time of the last report. */
  private counts: (number | null)[] = [];
  private reported = 0;
  private timer: ReturnType<typeof setTimeout> | undefined;
  private end!: (problem?: unknown) => void;

  constructor(
    pelt: Pelt,
    private readonly scene: EngineScene,
    private readonly question: Questions['sweep'],
    private readonly report: (progress: SweepProgress) => void,
  ) {
    this.crowd = new SceneCrowd(pelt, scene, question.by);
    this.hash = pelt.makeContactHash();
    this.tally = new TouchTally(this.crowd.characters);
    this.ended = new Promise((resolve, reject) => {
      this.end = (problem) => (problem === undefined ? resolve(null) : reject(problem));
    });
    this.goOn();
  }

  stop(): void {
    clearTimeout(this.timer);
    this.crowd.delete();
    this.hash.delete();
    this.end();
  }

  private goOn(): void {
    this.timer = setTimeout(() => {
      try {
        this.advance();
      } catch (problem) {
        this.end(problem);
      }
    });
  }

  private advance(): void {
    const end = performance.now() + SLICE_MILLISECONDS;
    while (!this.isDone() && performance.now() < end) this.counts.push(this.countFrame());
    if (this.isDone() || end - this.reported > REPORT_MILLISECONDS) this.reportCounts();
    if (this.isDone()) this.end();
    else this.goOn();
  }

  private reportCounts(): void {
    const total = this.isDone() ? this.total() : null;
    this.report({ id: this.question.id, counts: this.counts, total });
    this.counts = [];
    this.reported = performance.now();
  }

  private isDone(): boolean {
    return this.next === this.scene.frameCount;
  }

  private countFrame(): number | null {
    const frame = this.next++;
    if (!isIn(this.question.frames, frame)) return null;
    this.crowd.set(this.scene, frame);
    const found = this.crowd.collide(this.question.firstContact);
    this.hash.addCrowd(frame, found.ofBodies);
    this.tally.addAll(frame, found.contacts);
    this.ignored += found.ignored;
    return found.count;
  }

  private total(): SweepTotal {
    return {
      hash: this.question.firstContact ? null : this.hash.value,
      ignored: this.ignored,
      touches: this.tally.sorted(),
    };
  }
}

function isIn(frames: FrameRange | null, frame: number): boolean {
  if (!frames) return true;
  const [first, end, step] = frames;
  return frame >= first && frame < end && (frame - first) % step === 0;
}
