/** What `pelt check --html` and `pelt view` have left in the page; README.md tells the format. */

import type { NamedFile, ReadingOptions } from '../worker/protocol';

export interface Report {
  format: 'pelt-report';
  version: 1;
  /** The words by which it was made. */
  command: string;
  /** One of `files`. */
  scene: string;
  /** Base64, by paths. */
  files: Record<string, string>;
  reading: ReadingOptions;
  firstContact: boolean;
  /** None from `pelt view`, which leaves it to the page to find one. */
  answer: ReportAnswer | null;
}

export interface ReportAnswer {
  /** First, end, step. */
  frames: [number, number, number];
  /** Contacts of each of them. */
  counts: number[];
  /** None where contacts were limited. */
  hash: string | null;
}

/** Nothing where the page is no report. */
export function findReport(page: Document): Report | null {
  const text = page.getElementById('pelt-data')?.textContent?.trim();
  return text ? (JSON.parse(text) as Report) : null;
}

export function filesOf({ files }: Report): NamedFile[] {
  return Object.entries(files).map(([path, base64]) => ({ path, bytes: decode(base64) }));
}

function decode(base64: string): Uint8Array<ArrayBuffer> {
  return Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
}

/** Whether the page counts as the command did; nothing until it has counted all of its frames. */
export function agrees(answer: ReportAnswer, counts: readonly number[]): boolean | null {
  const [first, end, step] = answer.frames;
  if (counts.length < end) return null;
  return answer.counts.every((count, i) => counts[first + i * step] === count);
}
