import type { Character } from 'pelt';
import type { Touch } from './protocol';
import { placesOf, surfaceOf, type Places } from './surfaces';

/** A touch, and its contacts in the last of its frames. */
interface Counted {
  touch: Touch;
  last: { frame: number; contacts: number };
}

/** Counts contacts by the parts and joints that they are between, frame after frame. */
export class TouchTally {
  private readonly places: Places[];
  private readonly mostPlaces: number;
  /** Indexed by `keyOf`, because strings would cost more than the query. */
  private readonly touches = new Map<number, Counted>();

  /** `characters` has that of each instance. */
  constructor(private readonly characters: readonly Character[]) {
    this.places = characters.map(placesOf);
    this.mostPlaces = Math.max(1, ...this.places.map(({ count }) => count));
  }

  /** `contacts` as a crowd has them. */
  addAll(frame: number, contacts: Uint32Array): void {
    for (let i = 0; i < contacts.length; i += 4) {
      this.add(frame, contacts[i], contacts[i + 1], contacts[i + 2], contacts[i + 3]);
    }
  }

  /** The most contacts first. */
  sorted(): Touch[] {
    const touches = [...this.touches.values()].map(({ touch }) => touch);
    return touches.sort((one, other) => other.contacts - one.contacts);
  }

  private add(frame: number, a: number, b: number, triangleA: number, triangleB: number): void {
    // Contacts of an instance with itself have no sides.
    const { ofTriangle } = this.places[a];
    if (a === b && ofTriangle[triangleA] > ofTriangle[triangleB]) {
      [triangleA, triangleB] = [triangleB, triangleA];
    }
    const key = this.keyOf(a, b, triangleA, triangleB);
    const counted = this.touches.get(key) ?? this.begin(key, a, b, triangleA, triangleB);
    const { touch } = counted;
    if (counted.last.frame !== frame) counted.last = { frame, contacts: 0 };
    ++touch.contacts;
    ++counted.last.contacts;
    if (counted.last.contacts > touch.worst.contacts) touch.worst = counted.last;
  }

  /** A number for two places of two instances; exact for all scenes that fit into memory. */
  private keyOf(a: number, b: number, triangleA: number, triangleB: number): number {
    const instances = a * this.characters.length + b;
    const placeA = this.places[a].ofTriangle[triangleA];
    const placeB = this.places[b].ofTriangle[triangleB];
    return (instances * this.mostPlaces + placeA) * this.mostPlaces + placeB;
  }

  private begin(key: number, a: number, b: number, triangleA: number, triangleB: number): Counted {
    const touch = {
      a: surfaceOf(this.characters[a], a, triangleA),
      b: surfaceOf(this.characters[b], b, triangleB),
      contacts: 0,
      worst: { frame: -1, contacts: 0 },
    };
    const counted = { touch, last: { frame: -1, contacts: 0 } };
    this.touches.set(key, counted);
    return counted;
  }
}
