import type { Character } from 'pelt';
import type { Touch } from './protocol';
import { surfaceOf } from './surfaces';

/** Counts contacts by the parts and joints that they are between. */
export class TouchTally {
  private readonly touches = new Map<string, Touch>();

  /** `characters` has that of each instance. */
  constructor(private readonly characters: readonly Character[]) {}

  add(a: number, b: number, triangleA: number, triangleB: number): void {
    const key = `${this.placeOf(a, triangleA)} ${this.placeOf(b, triangleB)}`;
    const touch = this.touches.get(key);
    if (touch) ++touch.contacts;
    else this.touches.set(key, this.makeTouch(a, b, triangleA, triangleB));
  }

  /** The most contacts first. */
  sorted(): Touch[] {
    return [...this.touches.values()].sort((one, other) => other.contacts - one.contacts);
  }

  private placeOf(instance: number, triangle: number): string {
    const { triangleParts, triangleJoints } = this.characters[instance];
    return `${instance}:${triangleParts[triangle]}:${triangleJoints[triangle]}`;
  }

  private makeTouch(a: number, b: number, triangleA: number, triangleB: number): Touch {
    return {
      a: surfaceOf(this.characters[a], a, triangleA),
      b: surfaceOf(this.characters[b], b, triangleB),
      contacts: 1,
    };
  }
}
