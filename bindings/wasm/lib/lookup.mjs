/** Converts names to numbers of the engine. */

import * as check from './checks.mjs';
import { invalid } from './errors.mjs';

/** Part number that means the whole character. */
const kWhole = 0xffffffff;

/** Returns the number of a clip; -1 for the default pose. */
export function clipNumber(memory, { name, clips }, clip) {
  if (clip === null) return -1;
  const number = clips.findIndex((known) => known.name === clip);
  if (number >= 0) return number;
  check.text(clip, 'clip');
  const known = clips.map((one) => one.name);
  const rest = known.length > 0 ? memory.suggestion(clip, known) : ', it has none';
  throw invalid(`${JSON.stringify(name)} has no clip ${JSON.stringify(clip)}${rest}`);
}

/** Returns the number of a part; null means the whole character. */
export function partNumber({ name, parts }, part) {
  if (part === null) return kWhole;
  if (check.count(part, 'part') < parts.length) return part;
  throw invalid(`part: ${JSON.stringify(name)} has no part ${part}`);
}
