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
    return { id: request.id, answer: await (await desk).answer(request) };
  } catch (error) {
    return { id: request.id, problem: error instanceof Error ? error.message : String(error) };
  }
}

/** The large arrays of a frame change hands instead of being copied. */
function buffersOf(reply: Reply): Transferable[] {
  if (!('answer' in reply) || !reply.answer || !('instances' in reply.answer)) return [];
  const { instances, glow } = reply.answer;
  const arrays = instances.flatMap(({ positions, normals, boxes }) => [positions, normals, boxes]);
  return [...arrays, glow.corners, glow.centres].map(({ buffer }) => buffer as ArrayBuffer);
}
