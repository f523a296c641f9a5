/** The page's end of the worker: questions go out, answers come back as promises. */

import EngineWorker from '../worker/main?worker&inline';
import type { Answers, Kind, Questions, Reply, SweepProgress } from '../worker/protocol';

interface Waiting {
  resolve: (answer: Answers[Kind]) => void;
  reject: (problem: Error) => void;
}

export class Client {
  private readonly worker = new EngineWorker();
  private readonly waiting = new Map<number, Waiting>();
  private lastId = 0;

  constructor(
    private readonly onProgress: (progress: SweepProgress) => void,
    onFailure: (message: string) => void,
  ) {
    this.worker.onerror = ({ message }) => onFailure(message);
    this.worker.onmessage = ({ data }: MessageEvent<Reply>) => this.receive(data);
  }

  /** Transfers arrays that the page no longer needs, instead of copying them. */
  ask<K extends Kind>(kind: K, question: Questions[K]): Promise<Answers[K]> {
    const id = ++this.lastId;
    this.worker.postMessage({ id, kind, question }, buffersOf(question));
    return new Promise<Answers[Kind]>((resolve, reject) => {
      this.waiting.set(id, { resolve, reject });
    }) as Promise<Answers[K]>;
  }

  private receive(reply: Reply): void {
    if ('progress' in reply) return this.onProgress(reply.progress);
    const { resolve, reject } = this.waiting.get(reply.id)!;
    this.waiting.delete(reply.id);
    if ('problem' in reply) reject(new Error(reply.problem));
    else resolve(reply.answer);
  }
}

function buffersOf(question: Questions[Kind]): Transferable[] {
  return arraysOf(question).map(({ buffer }) => buffer as ArrayBuffer);
}

function arraysOf(question: Questions[Kind]): ArrayBufferView[] {
  if ('spares' in question) {
    return question.spares.flatMap(({ positions, normals }) => [positions, normals]);
  }
  const files = 'files' in question && Array.isArray(question.files) ? question.files : [];
  return files.map(({ bytes }) => bytes);
}
