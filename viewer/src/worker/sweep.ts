/** Counts the contacts of every frame in the background, a few milliseconds at a time. */

import type { ContactHash, Crowd, CrowdContacts, Pelt, Scene as EngineScene } from 'pelt';
import type { Questions, SweepProgress, SweepTotal } from './protocol';
import { TouchTally } from './touches';

/** So long may a frame that is wanted now have to wait. */
const SLICE_MILLISECONDS = 6;

const REPORT_MILLISECONDS = 100;

export class Sweep {
  private readonly crowd: Crowd;
  private readonly hash: ContactHash;
  private readonly tally: TouchTally;
  private next = 0;
  /** Not yet reported, and when the last were. */
  private counts: number[] = [];
  private reported = 0;
  private timer: ReturnType<typeof setTimeout>;

  constructor(
    pelt: Pelt,
    private readonly scene: EngineScene,
    private readonly question: Questions['sweep'],
    private readonly report: (progress: SweepProgress) => void,
  ) {
    const characters = scene.instances.map(({ character }) => scene.characters[character]);
    this.crowd = pelt.makeCrowd();
    for (const character of characters) this.crowd.add(character);
    this.hash = pelt.makeContactHash();
    this.tally = new TouchTally(characters);
    this.timer = setTimeout(() => this.advance());
  }

  stop(): void {
    clearTimeout(this.timer);
    this.crowd.delete();
    this.hash.delete();
  }

  private advance(): void {
    const end = performance.now() + SLICE_MILLISECONDS;
    while (!this.isDone() && performance.now() < end) this.counts.push(this.countFrame());
    if (this.isDone() || end - this.reported > REPORT_MILLISECONDS) this.reportCounts();
    if (!this.isDone()) this.timer = setTimeout(() => this.advance());
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

  private countFrame(): number {
    const frame = this.next++;
    this.scene.instances.forEach((_, instance) => {
      this.crowd.setPalette(instance, this.scene.palette(instance, frame));
      this.crowd.setMorphWeights(instance, this.scene.morphWeights(instance, frame));
    });
    const found = this.crowd.collide({ firstContact: this.question.firstContact });
    this.hash.addCrowd(frame, found.contacts);
    this.addTouches(found);
    return found.count;
  }

  private addTouches({ contacts }: CrowdContacts): void {
    for (let i = 0; i < contacts.length; i += 4) {
      this.tally.add(contacts[i], contacts[i + 1], contacts[i + 2], contacts[i + 3]);
    }
  }

  private total(): SweepTotal {
    const hash = this.question.firstContact ? null : this.hash.value;
    return { hash, touches: this.tally.sorted() };
  }
}
