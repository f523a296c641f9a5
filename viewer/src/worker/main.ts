/** The worker: one request after the other, and the sweep in between. */

import { MeshoptDecoder } from 'meshoptimizer/decoder';
import { loadPelt } from 'pelt';
import { Desk } from './desk';
import type { Reply, Request } from './protocol';

const desk = openDesk();

self.onmessage = async ({ data }: MessageEvent<Request>) => {
  const reply = await answer(data);
  postMessage(reply, { transfer: buffersOf(reply) });
};

async function openDesk(): Promise<Desk> {
  const [pelt] = await Promise.all([loadPelt(), MeshoptDecoder.ready]);
  return new Desk(pelt, (progress) => postMessage({ progress } satisfies Reply));
}

async function answer(request: Request): Promise<Reply> {
  try {
    return { id: request.id, answer: (await desk).answer(request) };
  } catch (error) {
    return { id: request.id, problem: error instanceof Error ? error.message : String(error) };
  }
}

/** The large arrays of a frame change hands instead of being copied. */
function buffersOf(reply: Reply): ArrayBuffer[] {
  if (!('answer' in reply) || !reply.answer || !('instances' in reply.answer)) return [];
  return reply.answer.instances.flatMap((instance) =>
    Object.values(instance).map((array: Float32Array<ArrayBuffer>) => array.buffer),
  );
}
