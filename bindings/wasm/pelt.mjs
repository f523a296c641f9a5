/** Exact collision detection for skinned characters; pelt.d.ts is the reference. */

import makeModule from './engine.mjs';
import { Character } from './lib/character.mjs';
import * as check from './lib/checks.mjs';
import { ContactHash, Crowd } from './lib/crowd.mjs';
import { withDecoder } from './lib/decoder.mjs';
import { containment, deepestVertex, distance } from './lib/distances.mjs';
import { invalid } from './lib/errors.mjs';
import { withFiles } from './lib/files.mjs';
import { expose } from './lib/internals.mjs';
import { Memory } from './lib/memory.mjs';
import {
  collideMoving,
  firstContact,
  selfCollideMoving,
  selfTouchesWhileMoving,
  touchWhileMoving,
} from './lib/motion.mjs';
import {
  kCreatureRules,
  kFaceRules,
  kMeshRules,
  kModelRules,
  kReadRules,
  readObject,
  readOptions,
} from './lib/options.mjs';
import {
  clearance,
  describeContacts,
  different,
  isWithin,
  mostContacts,
  readContacts,
} from './lib/queries.mjs';
import { Pose } from './lib/pose.mjs';
import { Scene } from './lib/scene.mjs';
import { CollisionSearch } from './lib/search.mjs';
import { ContactTally, selfCollide, selfIntersects } from './lib/self.mjs';
import { requireSimd } from './lib/simd.mjs';
import { readStats } from './lib/stats.mjs';

export { PeltError } from './lib/errors.mjs';
export { FeatureKind } from './lib/motion.mjs';
export { NodeState } from './lib/pose.mjs';
export { ContactKind } from './lib/queries.mjs';

export async function loadPelt() {
  requireSimd();
  return new Pelt(new Memory(await makeModule()));
}

/** three.js has indices of 16 bits for small meshes. */
function indicesOf(triangles, name) {
  const indices = triangles instanceof Uint16Array ? Uint32Array.from(triangles) : triangles;
  return check.rows(indices, 3, name);
}

class Pelt {
  #memory;
  #module;

  constructor(memory) {
    this.#memory = memory;
    this.#module = memory.module;
    expose(this, memory);
  }

  get version() {
    return this.#memory.text(this.#module._pelt_version());
  }

  get demoScene() {
    return this.#memory.text(this.#module._pelt_demo_scene());
  }

  get lastStats() {
    return readStats(this.#memory);
  }

  get hasEnded() {
    return this.#memory.gate.hasEnded;
  }

  readCharacter(file, given = {}) {
    const options = readObject(this.#memory, given, kReadRules);
    const { meshoptDecode, files, name, ...rest } = options;
    if (name === undefined) throw invalid("name: a character needs one, as in { name: 'knight' }");
    const bytes = check.bytes(file, 'file');
    const read = (folder) =>
      this.#memory.withBytes(bytes, (address) =>
        this.#prepare({ ...rest, name, folder }, (...prepared) =>
          this.#module._pelt_read_character(address, bytes.length, ...prepared),
        ),
      );
    return withDecoder(this.#memory, meshoptDecode, () =>
      files === undefined ? read('') : withFiles(this.#memory, files, read),
    );
  }

  generateCreature(options = {}) {
    return this.#prepare(readObject(this.#memory, options, kCreatureRules), (...prepared) =>
      this.#module._pelt_generate_creature(...prepared),
    );
  }

  generateFace(options = {}) {
    return this.#prepare(readObject(this.#memory, options, kFaceRules), (...prepared) =>
      this.#module._pelt_generate_face(...prepared),
    );
  }

  makeCharacter(mesh) {
    const arrays = { name: 'mesh', weld: false, ...readObject(this.#memory, mesh, kMeshRules, 'mesh') };
    const { restPositions, triangles, ...options } = arrays;
    const positions = check.rows(restPositions, 3, 'mesh.restPositions', Float32Array);
    const indices = indicesOf(triangles, 'mesh.triangles');
    const sizes = [positions, indices].map(({ length }) => length / 3);
    return this.#memory.withBytes(positions, (vertices) =>
      this.#memory.withBytes(indices, (corners) =>
        this.#prepare(options, (...prepared) =>
          this.#module._pelt_make_character(vertices, sizes[0], corners, sizes[1], ...prepared),
        ),
      ),
    );
  }

  readScene(path, files, given) {
    const { meshoptDecode, ...options } = readOptions(this.#memory, given, kModelRules);
    const read = () =>
      this.#memory.withText(check.path(path, 'path'), (address) =>
        this.#withOptions(options, (json) =>
          this.#memory.accepted(this.#module._pelt_read_scene(address, json)),
        ),
      );
    const parts = this.#memory.json(
      withDecoder(this.#memory, meshoptDecode, () => withFiles(this.#memory, files, read)),
    );
    parts.characters = parts.characters.map((handle) => new Character(this.#memory, handle));
    return new Scene(this.#memory, parts);
  }

  makeScene(parts) {
    return new Scene(this.#memory, parts);
  }

  collide(a, b, options = undefined) {
    const most = mostContacts(this.#memory, options);
    this.#module._pelt_collide(...different(this.#memory, a, b), most);
    return readContacts(this.#memory);
  }

  collideEagerly(a, b, options = undefined) {
    const most = mostContacts(this.#memory, options);
    this.#module._pelt_collide_eagerly(...different(this.#memory, a, b), most);
    return readContacts(this.#memory);
  }

  intersects(a, b) {
    return this.#module._pelt_intersects(...different(this.#memory, a, b)) !== 0;
  }

  describeContacts(a, b, pairs) {
    return describeContacts(this.#memory, different(this.#memory, a, b), pairs);
  }

  selfCollide(pose, filter, options = undefined) {
    return selfCollide(this.#memory, pose, filter, options);
  }

  selfIntersects(pose, filter) {
    return selfIntersects(this.#memory, pose, filter);
  }

  describeSelfContacts(pose, pairs) {
    const handle = this.#memory.handles.given(pose, Pose, 'pose');
    return describeContacts(this.#memory, [handle, handle], pairs);
  }

  distance(a, b, options = undefined) {
    return distance(this.#memory, different(this.#memory, a, b), options);
  }

  clearance(a, b, tolerance, options = undefined) {
    return clearance(this.#memory, a, b, tolerance, options);
  }

  isWithin(a, b, tolerance) {
    return isWithin(this.#memory, a, b, tolerance);
  }

  deepestVertex(a, b) {
    return deepestVertex(this.#memory, different(this.#memory, a, b), b);
  }

  containment(a, b) {
    return containment(this.#memory, different(this.#memory, a, b));
  }

  collideMoving(a, b, options = undefined) {
    return collideMoving(this.#memory, a, b, options);
  }

  touchWhileMoving(a, b) {
    return touchWhileMoving(this.#memory, a, b);
  }

  firstContact(a, b, options = undefined) {
    return firstContact(this.#memory, a, b, options);
  }

  selfCollideMoving(motion, filter, options = undefined) {
    return selfCollideMoving(this.#memory, motion, filter, options);
  }

  selfTouchesWhileMoving(motion, filter) {
    return selfTouchesWhileMoving(this.#memory, motion, filter);
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

  /** Returns the character that `make(caps, count, json)` makes: with caps of vertices, and other options. */
  #prepare({ offsetCaps, ...options }, make) {
    const isSame = typeof offsetCaps === 'number';
    const caps = isSame || offsetCaps === undefined ? new Float32Array(0) : offsetCaps;
    const handle = this.#memory.withBytes(caps, (address) =>
      this.#withOptions(isSame ? { ...options, offsetCaps } : options, (json) =>
        make(address, caps.length, json),
      ),
    );
    return new Character(this.#memory, this.#memory.accepted(handle));
  }

  #withOptions(options, use) {
    return this.#memory.withText(JSON.stringify(options), use);
  }
}
