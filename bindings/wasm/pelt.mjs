/** Exact collision detection for skinned characters; pelt.d.ts is the reference. */

import makeModule from './engine.mjs';
import { Character } from './lib/character.mjs';
import * as check from './lib/checks.mjs';
import { ContactHash, Crowd } from './lib/crowd.mjs';
import { invalid, PeltError } from './lib/errors.mjs';
import { withDecoder, withFiles } from './lib/files.mjs';
import { expose, memoryOf } from './lib/internals.mjs';
import { Memory } from './lib/memory.mjs';
import * as motion from './lib/motion.mjs';
import {
  kCreatureRules,
  kFaceRules,
  kMeshRules,
  kModelRules,
  kReadRules,
  readObject,
  readOptions,
} from './lib/options.mjs';
import * as queries from './lib/queries.mjs';
import { Scene } from './lib/scene.mjs';
import { CollisionSearch } from './lib/search.mjs';
import { ContactTally, selfCollide, selfIntersects } from './lib/self.mjs';

export { PeltError } from './lib/errors.mjs';
export { FeatureKind } from './lib/motion.mjs';
export { NodeState } from './lib/pose.mjs';
export { ContactKind } from './lib/queries.mjs';

export async function loadPelt() {
  requireSimd();
  return new Pelt(new Memory(await makeModule()));
}

class Pelt {
  #memory;

  constructor(memory) {
    this.#memory = memory;
    expose(this, memory);
  }

  get version() {
    return this.#memory.text('version');
  }

  get demoScene() {
    return this.#memory.text('demo_scene');
  }

  get lastStats() {
    return this.#memory.stats();
  }

  get hasEnded() {
    return this.#memory.hasEnded;
  }

  readCharacter(file, given = {}) {
    const options = readObject(this.#memory, given, kReadRules);
    const { meshoptDecode, files, name, ...rest } = options;
    if (name === undefined) throw invalid("name: a character needs one, as in { name: 'knight' }");
    const bytes = check.bytes(file, 'file');
    const read = (folder) => this.#make('read_character', [bytes], { ...rest, name, folder });
    return withDecoder(this.#memory, meshoptDecode, () =>
      files === undefined ? read('') : withFiles(this.#memory, files, read),
    );
  }

  generateCreature(options = {}) {
    return this.#make('generate_creature', [], readObject(this.#memory, options, kCreatureRules));
  }

  generateFace(options = {}) {
    return this.#make('generate_face', [], readObject(this.#memory, options, kFaceRules));
  }

  makeCharacter(mesh) {
    const arrays = { name: 'mesh', weld: false, ...readObject(this.#memory, mesh, kMeshRules, 'mesh') };
    const { restPositions, triangles, ...options } = arrays;
    const positions = check.rows(restPositions, 3, 'mesh.restPositions', Float32Array);
    const indices = indicesOf(triangles, 'mesh.triangles');
    return this.#make('make_character', [positions, indices], options);
  }

  readScene(path, files, given) {
    const { meshoptDecode, ...options } = readOptions(this.#memory, given, kModelRules);
    const read = () =>
      this.#memory.json('read_scene', check.path(path, 'path'), JSON.stringify(options));
    const parts = withDecoder(this.#memory, meshoptDecode, () => withFiles(this.#memory, files, read));
    parts.characters = parts.characters.map((handle) => new Character(this.#memory, handle));
    return new Scene(this.#memory, parts);
  }

  makeScene(parts) {
    return new Scene(this.#memory, parts);
  }

  makeSearch(a, b, options = undefined) {
    return new CollisionSearch(this.#memory, a, b, options);
  }

  makeCrowd() {
    return new Crowd(this.#memory);
  }

  makeContactHash() {
    return new ContactHash(this.#memory);
  }

  makeContactTally() {
    return new ContactTally(this.#memory);
  }

  /** Returns the character that a function makes of arrays, caps of vertices, and other options. */
  #make(name, arrays, { offsetCaps, ...options }) {
    const isSame = typeof offsetCaps === 'number';
    const caps = isSame || offsetCaps === undefined ? new Float32Array() : offsetCaps;
    const json = JSON.stringify(isSame ? { ...options, offsetCaps } : options);
    return new Character(this.#memory, this.#memory.call(name, ...arrays, caps, json));
  }
}

/** Methods that are functions of the same name, which take the engine's memory first. */
const kQueries = {
  clearance: queries.clearance,
  collide: queries.collide,
  collideEagerly: queries.collideEagerly,
  containment: queries.containment,
  deepestVertex: queries.deepestVertex,
  describeContacts: queries.describeContacts,
  describeSelfContacts: queries.describeSelfContacts,
  distance: queries.distance,
  intersects: queries.intersects,
  isWithin: queries.isWithin,
  collideMoving: motion.collideMoving,
  firstContact: motion.firstContact,
  selfCollideMoving: motion.selfCollideMoving,
  selfTouchesWhileMoving: motion.selfTouchesWhileMoving,
  touchWhileMoving: motion.touchWhileMoving,
  selfCollide,
  selfIntersects,
};
for (const [name, query] of Object.entries(kQueries)) {
  Object.defineProperty(Pelt.prototype, name, {
    value(...given) {
      return query(memoryOf(this), ...given);
    },
    configurable: true,
    writable: true,
  });
}

/** three.js has indices of 16 bits for small meshes. */
function indicesOf(triangles, name) {
  const indices = triangles instanceof Uint16Array ? Uint32Array.from(triangles) : triangles;
  return check.rows(indices, 3, name);
}

/** A module whose only function returns a vector of zeros. */
const kUsesSimd = Uint8Array.of(
  ...[0x00, 0x61, 0x73, 0x6d, 0x01, 0x00, 0x00, 0x00],
  ...[0x01, 0x05, 0x01, 0x60, 0x00, 0x01, 0x7b],
  ...[0x03, 0x02, 0x01, 0x00],
  ...[0x0a, 0x08, 0x01, 0x06, 0x00, 0x41, 0x00, 0xfd, 0x0f, 0x0b],
);

/** Throws a readable error if SIMD is missing; otherwise compiling the engine would fail. */
function requireSimd() {
  if (globalThis.WebAssembly?.validate(kUsesSimd)) return;
  throw new PeltError(
    'unsupported',
    'this browser or Node does not support WebAssembly with SIMD: use Chrome or Edge 91, ' +
      'Firefox 89, Safari 16.4, Node 18, or newer',
  );
}
