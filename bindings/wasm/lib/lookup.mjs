/** How the engine numbers what callers name. */

import * as check from './checks.mjs';
import { invalid } from './errors.mjs';

/** Stands for all parts together. */
const kWhole = 0xffffffff;

/** -1 is no clip. */
export function clipNumber(memory, { name, clips }, clip) {
  if (clip === null) return -1;
  const number = clips.findIndex((known) => known.name === clip);
  if (number >= 0) return number;
  check.text(clip, 'clip');
  const known = clips.map((one) => one.name);
  const rest = known.length > 0 ? memory.suggestion(clip, known) : ', it has none';
  throw invalid(`${JSON.stringify(name)} has no clip ${JSON.stringify(clip)}${rest}`);
}

/** null is the whole. */
export function partNumber({ name, parts }, part) {
  if (part === null) return kWhole;
  if (check.count(part, 'part') < parts.length) return part;
  throw invalid(`part: ${JSON.stringify(name)} has no part ${part}`);
}
