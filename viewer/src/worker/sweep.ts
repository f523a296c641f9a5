/** Counts the contacts of every checked frame in the background, a few milliseconds at a time. */

import type {
  Character,
  ContactHash,
  ContactTally,
  LeftOut,
  Pelt,
  Scene as EngineScene,
} from 'pelt';
import { isInRange } from '../scene/scene';
import { partsOf } from './bodies';
import { OwnContacts, type SelfFilters } from './own_contacts';
import type { By, Questions, SelfQuestion, Step, SweepProgress, SweepTotal } from './protocol';
import { countSelf, SceneCrowd } from './scene_crowd';
import { Steps } from './steps';
import { NOTHING_LEFT_OUT, sumOfLeftOut } from './sums';
import { TouchTally } from './touches';

/** Longest time that counting may delay a requested frame. */
const SLICE_MILLISECONDS = 6;

const REPORT_MILLISECONDS = 100;

export class Sweep {
  /** Settled when all is counted or given up, rejected when a frame cannot be. */
  readonly ended: Promise<null>;
  /** Null until the filters are ready. */
  private crowd: SceneCrowd | null = null;
  /** Null once the filters are ready. */
  private search: AlwaysSearch | null = null;
  private readonly hash: ContactHash;
  private tally: TouchTally | null = null;
  /** Null if the steps between frames are not tested. */
  private steps: Steps | null = null;
  private searched = 0;
  private next = 0;
  private ignored = 0;
  private leftOut: LeftOut = NOTHING_LEFT_OUT;
  /** Counts not reported yet, and the time of the last report. */
  private counts: (number | null)[] = [];
  private selfCounts: (number | null)[] = [];
  private undecided: (number | null)[] = [];
  private isDecided = true;
  private foundSteps: Step[] = [];
  private reported = 0;
  private timer: ReturnType<typeof setTimeout> | undefined;
  private end!: (problem?: unknown) => void;

  constructor(
    private readonly pelt: Pelt,
    private readonly filters: SelfFilters,
    private readonly scene: EngineScene,
    private readonly question: Questions['sweep'],
    private readonly report: (progress: SweepProgress) => void,
  ) {
    this.hash = pelt.makeContactHash();
    this.ended = new Promise((resolve, reject) => {
      this.end = (problem) => (problem === undefined ? resolve(null) : reject(problem));
    });
    this.goOn();
  }

  stop(): void {
    clearTimeout(this.timer);
    this.crowd?.delete();
    this.search?.delete();
    this.hash.delete();
    this.steps?.delete();
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
    if (!this.crowd && !this.search) this.begin();
    while (!this.isDone() && performance.now() < end) this.step();
    if (this.isDone() || end - this.reported > REPORT_MILLISECONDS) this.reportCounts();
    if (this.isDone()) this.end();
    else this.goOn();
  }

  private reportCounts(): void {
    const total = this.isDone() ? this.total() : null;
    const { searched, counts, selfCounts, undecided, foundSteps: steps } = this;
    this.report({ id: this.question.id, searched, counts, selfCounts, undecided, steps, total });
    [this.counts, this.selfCounts, this.undecided, this.foundSteps] = [[], [], [], []];
    this.reported = performance.now();
  }

  private isDone(): boolean {
    return this.next === this.scene.frameCount;
  }

  /** Finds what nearly all frames have in common, if that is not to count; then counts. */
  private begin(): void {
    const { pelt, filters, scene, question } = this;
    const { by, self, between } = question;
    if (filters.areReady(scene, by, self)) {
      this.crowd = new SceneCrowd(pelt, scene, by, { question: self, filters });
      this.tally = new TouchTally(this.crowd.characters);
      this.steps = between ? new Steps(pelt, scene, this.crowd) : null;
    } else {
      this.search = new AlwaysSearch(pelt, filters, scene, by, self!);
    }
  }

  private step(): void {
    if (this.search) this.searchFrame(this.search);
    else this.countFrame(this.crowd!);
  }

  private searchFrame(search: AlwaysSearch): void {
    const frame = this.searched++;
    if (isInRange(frame, this.question.frames)) search.addFrame(frame);
    if (this.searched < this.scene.frameCount) return;
    search.end();
    search.delete();
    this.search = null;
    this.begin();
  }

  private countFrame(crowd: SceneCrowd): void {
    const frame = this.next++;
    if (!isInRange(frame, this.question.frames)) {
      this.counts.push(null);
      this.selfCounts.push(null);
      this.undecided.push(null);
      return;
    }
    this.steps?.begin();
    crowd.set(this.scene, frame);
    const found = crowd.collide(this.question);
    const step = this.steps?.end(frame, found);
    if (step) this.foundSteps.push(step);
    this.hash.addCrowd(frame, found.ofBodies);
    this.tally!.addAll(frame, found.contacts);
    this.ignored += found.ignored;
    this.leftOut = sumOfLeftOut([this.leftOut, found.leftOut]);
    this.counts.push(found.count);
    this.undecided.push(found.undecided);
    this.isDecided &&= found.undecided === 0;
    this.selfCounts.push(this.question.self ? countSelf(found) : 0);
  }

  private total(): SweepTotal {
    return {
      hash: this.question.maxContacts === null && this.isDecided ? this.hash.value : null,
      betweenHash: this.steps?.hashValue ?? null,
      ignored: this.ignored,
      leftOut: this.leftOut,
      touches: this.tally!.sorted(),
    };
  }
}

/**
 * Finds the pairs of triangles that touch in nearly all frames, one frame at a time, for the filter
 * that drops them.
 */
class AlwaysSearch {
  /** The query of each instance. */
  private readonly queries: OwnContacts[];
  private readonly tallies: ReadonlyMap<Character, ContactTally>;

  constructor(
    pelt: Pelt,
    private readonly filters: SelfFilters,
    private readonly scene: EngineScene,
    private readonly by: By,
    private readonly self: SelfQuestion,
  ) {
    const question = { ...self, always: null };
    const characters = scene.instances.map(({ character }) => scene.characters[character]);
    this.queries = characters.map((character) => {
      return new OwnContacts(pelt, character, partsOf(character, by), filters, question);
    });
    this.tallies = new Map(
      [...new Set(characters)].map((character) => [character, pelt.makeContactTally()]),
    );
  }

  addFrame(frame: number): void {
    this.queries.forEach((query, i) => {
      const [palette, weights] = [this.scene.palette(i, frame), this.scene.morphWeights(i, frame)];
      this.tallies.get(query.character)!.add(query.find(palette, weights));
    });
  }

  /** Hands the pairs to the filters. */
  end(): void {
    const share = this.self.always!;
    const pairs = new Map(
      [...this.tallies].map(([character, tally]) => [character, tally.inShareOfPoses(share)]),
    );
    this.filters.knowAlways(this.scene, this.by, this.self, pairs);
  }

  delete(): void {
    for (const query of this.queries) query.delete();
    for (const tally of this.tallies.values()) tally.delete();
  }
}
