/** The triangles in contact as the page draws them: corners and centres, ready to be uploaded. */

import type { Character } from 'pelt';
import type { Glow, PosedInstance } from './protocol';

/** Lengths are powers of two of triangles, so that arrays of the same length follow each other. */
const LEAST_TRIANGLES = 64;

/** Triangles of each instance that touch their own body, and triangles that touch other bodies. */
export function glowOf(
  characters: readonly Character[],
  instances: readonly Pick<PosedInstance, 'positions'>[],
  ofSelf: readonly Uint32Array[],
  ofPairs: readonly Uint32Array[],
): Glow {
  const triangles = sizeOf(ofSelf) + sizeOf(ofPairs);
  const room = roomFor(triangles);
  const glow = {
    triangles,
    ofSelf: sizeOf(ofSelf),
    corners: new Float32Array(9 * room),
    centres: new Float32Array(3 * room),
  };
  let next = 0;
  for (const touching of [ofSelf, ofPairs]) {
    instances.forEach(({ positions }, i) => {
      const corners = characters[i].triangles;
      for (const triangle of touching[i]) {
        writeTriangle(glow, next++, positions, corners.subarray(3 * triangle, 3 * triangle + 3));
      }
    });
  }
  return glow;
}

function sizeOf(sets: readonly Uint32Array[]): number {
  return sets.reduce((sum, { length }) => sum + length, 0);
}

export function roomFor(triangles: number): number {
  let room = LEAST_TRIANGLES;
  while (room < triangles) room *= 2;
  return room;
}

function writeTriangle(
  { corners, centres }: Glow,
  at: number,
  positions: Float32Array,
  vertices: Uint32Array,
): void {
  for (let corner = 0; corner < 3; ++corner) {
    for (let axis = 0; axis < 3; ++axis) {
      const place = positions[3 * vertices[corner] + axis];
      corners[9 * at + 3 * corner + axis] = place;
      centres[3 * at + axis] += place / 3;
    }
  }
}

/** The triangles of each instance that are in contact, each once. */
export class TriangleSets {
  private readonly isIn: Uint8Array[];

  /** `counts` has how many triangles each instance has. */
  constructor(counts: readonly number[]) {
    this.isIn = counts.map((count) => new Uint8Array(count));
  }

  /** `contacts` as a crowd has them; in the order in which they come there. */
  gather(contacts: Uint32Array): Uint32Array[] {
    const found: number[][] = this.isIn.map(() => []);
    const add = (instance: number, triangle: number) => {
      if (this.isIn[instance][triangle]) return;
      this.isIn[instance][triangle] = 1;
      found[instance].push(triangle);
    };
    for (let i = 0; i < contacts.length; i += 4) {
      add(contacts[i], contacts[i + 2]);
      add(contacts[i + 1], contacts[i + 3]);
    }
    found.forEach((triangles, i) => triangles.forEach((t) => (this.isIn[i][t] = 0)));
    return found.map((triangles) => Uint32Array.from(triangles));
  }
}
