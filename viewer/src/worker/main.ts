/** The worker: one request after the other, and the sweep in between. */

import { Keeper } from './keeper';
import type { Reply, Request } from './protocol';

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
