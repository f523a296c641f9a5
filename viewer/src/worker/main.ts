/** The worker: one request after the other, and the sweep in between. */

import { MeshoptDecoder } from 'meshoptimizer/decoder';
import { loadPelt, PeltError } from 'pelt';
import { Desk } from './desk';
import type { Reply, Request, SweepProgress } from './protocol';

/** Answers requests, and replaces an engine that has ended, usually because it ran out of memory. */
class Keeper {
  private desk: Promise<Desk>;
  /** Requests that created the current scene, to be repeated after a restart. */
  private onStage: Request[] = [];
  /** Why the stage is empty. */
  private lost = '';

  constructor(private readonly report: (progress: SweepProgress) => void) {
    this.desk = this.openDesk();
  }

  async answer(request: Request): Promise<Reply> {
    const { id } = request;
    if (this.lost && !isOpening(request)) return { id, problem: this.lost };
    const { desk } = this;
    try {
      const answer = await (await desk).answer(request);
      if (isOpening(request)) [this.onStage, this.lost] = [[request], ''];
      if (isAdding(request)) this.onStage.push(request);
      return { id, answer };
    } catch (error) {
      const problem = error instanceof Error ? error.message : String(error);
      const hasEnded = await desk.then(
        (asked) => asked.hasEnded,
        () => false,
      );
      return { id, problem: hasEnded ? this.replace(desk, request, reasonOf(error)) : problem };
    }
  }

  /** Drops the request that did not fit. The scene fits, unless it failed itself. */
  private replace(ended: Promise<Desk>, request: Request, reason: string): string {
    if (this.desk === ended) {
      const isStageGood = (isOpening(request) || isAdding(request)) && this.lost === '';
      this.lost = isStageGood ? '' : `${reason} Open smaller files, or fewer at once.`;
      this.desk = this.openDesk(isStageGood ? this.onStage : []);
    }
    return this.lost || `${reason} The scene is unchanged.`;
  }

  private async openDesk(onStage: readonly Request[] = []): Promise<Desk> {
    const [pelt] = await Promise.all([loadPelt(), MeshoptDecoder.ready]);
    const desk = new Desk(pelt, this.report);
    for (const request of onStage) await desk.answer(request);
    return desk;
  }
}

function reasonOf(error: unknown): string {
  const isMemory = error instanceof PeltError && error.code === 'out_of_memory';
  const what = isMemory ? 'The engine ran out of memory' : 'The engine failed';
  return `${what} and was restarted.`;
}

function isOpening({ kind }: Request): boolean {
  return ['openDemo', 'openScene', 'openReport', 'readCharacters'].includes(kind);
}

function isAdding({ kind }: Request): boolean {
  return kind === 'addCharacters';
}

const keeper = new Keeper((progress) => postMessage({ progress } satisfies Reply));

self.onmessage = async ({ data }: MessageEvent<Request>) => {
  const reply = await keeper.answer(data);
  postMessage(reply, { transfer: buffersOf(reply) });
};

/** Transfers the large arrays of a frame instead of copying them. */
function buffersOf(reply: Reply): Transferable[] {
  if (!('answer' in reply) || !reply.answer || !('instances' in reply.answer)) return [];
  const { instances, glow } = reply.answer;
  const arrays = instances.flatMap(({ positions, normals, boxes }) => [positions, normals, boxes]);
  return [...arrays, glow.corners, glow.centres].map(({ buffer }) => buffer as ArrayBuffer);
}
