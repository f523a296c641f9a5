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
