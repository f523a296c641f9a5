/** Exact collision detection for skinned characters; pelt.d.ts is the reference. */

import makeModule from './engine.mjs';
import { Character } from './lib/character.mjs';
import { ContactHash, Crowd } from './lib/crowd.mjs';
import { withFiles } from './lib/files.mjs';
import { Memory } from './lib/memory.mjs';
import { describeContacts, different, distance, mostContacts, readContacts } from './lib/queries.mjs';
import { Scene } from './lib/scene.mjs';

export { PeltError } from './lib/memory.mjs';
export { NodeState } from './lib/pose.mjs';
export { ContactKind } from './lib/queries.mjs';

export async function loadPelt() {
  return new Pelt(new Memory(await makeModule()));
}

class Pelt {
  #memory;
  #module;

  constructor(memory) {
    this.#memory = memory;
    this.#module = memory.module;
  }

  get version() {
    return this.#memory.text(this.#module._pelt_version());
  }

  get demoScene() {
    return this.#memory.text(this.#module._pelt_demo_scene());
  }

  get bytesInUse() {
    return this.#module._pelt_bytes_in_use();
  }

  readCharacter(file, { meshoptDecode, files, ...options }) {
    this.#module.meshoptDecode = meshoptDecode;
    const read = (folder) =>
      this.#memory.withBytes(file, (address) =>
        this.#withOptions({ ...options, folder }, (json) =>
          this.#character(this.#module._pelt_read_character(address, file.length, json)),
        ),
      );
    return files === undefined ? read('') : withFiles(this.#module, files, read);
  }

  generateCreature(options = {}) {
    return this.#withOptions(options, (json) =>
      this.#character(this.#module._pelt_generate_creature(json)),
    );
  }

  generateFace(options = {}) {
    return this.#withOptions(options, (json) =>
      this.#character(this.#module._pelt_generate_face(json)),
    );
  }

  readScene(path, files, { meshoptDecode, ...options } = {}) {
    this.#module.meshoptDecode = meshoptDecode;
    const read = () =>
      this.#memory.withText(path, (address) =>
        this.#withOptions(options, (json) =>
          this.#memory.accepted(this.#module._pelt_read_scene(address, json)),
        ),
      );
    const parts = this.#memory.json(withFiles(this.#module, files, read));
    parts.characters = parts.characters.map((handle) => new Character(this.#memory, handle));
    return new Scene(this.#memory, parts);
  }

  makeScene(parts) {
    return new Scene(this.#memory, parts);
  }

  collide(a, b, options = {}) {
    this.#module._pelt_collide(...different(a, b), mostContacts(options));
    return readContacts(this.#memory);
  }

  collideEagerly(a, b, options = {}) {
    this.#module._pelt_collide_eagerly(...different(a, b), mostContacts(options));
    return readContacts(this.#memory);
  }

  intersects(a, b) {
    return this.#module._pelt_intersects(...different(a, b)) !== 0;
  }

  describeContacts(a, b, pairs) {
    return describeContacts(this.#memory, a, b, pairs);
  }

  distance(a, b, options = {}) {
    return distance(this.#memory, a, b, options);
  }

  makeCrowd() {
    return new Crowd(this.#memory);
  }

  makeContactHash() {
    return new ContactHash(this.#memory);
  }

  #character(handle) {
    return new Character(this.#memory, this.#memory.accepted(handle));
  }

  #withOptions(options, use) {
    return this.#memory.withText(JSON.stringify(options), use);
  }
}
