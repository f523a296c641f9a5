/** Wrong arguments are refused with their names, and change nothing. */

import assert from 'node:assert/strict';
import test from 'node:test';
import { rock } from './gltf.mjs';
import { loadPelt, pelt, refused } from './support.mjs';

const creature = pelt.generateCreature({ triangles: 2000, joints: 30 });
const [a, b] = [creature.makePose(), creature.makePose()];

test('unknown options are refused with the closest known one', () => {
  refused(() => pelt.generateCreature({ triangels: 2000 }),
          'unknown option "triangels", did you mean "triangles"?');
  refused(() => pelt.generateFace({ joints: 20 }), /^unknown option "joints", expected one of "name"/);
  refused(() => pelt.readCharacter(rock(), { name: 'rock', folder: '/' }), /unknown option "folder"/);
  refused(() => pelt.readScene('s.json', {}, { renormalize: true }), /did you mean "renormalise"\?/);
  refused(() => pelt.collide(a, b, { first: true }), /unknown option "first"/);
  refused(() => pelt.distance(a, b, { max: 1 }), /unknown option "max"/);
  refused(() => pelt.makeCrowd().collide({ maxContact: 1 }), /did you mean "maxContacts"\?/);
});

test('options of the wrong kind are refused', () => {
  const expected = (options, message) => refused(() => pelt.generateCreature(options), message);
  const whole = 'triangles: expected a whole number from 0 to 4294967295, found ';
  expected({ triangles: '2000' }, `${whole}a string`);
  expected({ triangles: 2000.5 }, `${whole}2000.5`);
  expected({ triangles: -5 }, `${whole}-5`);
  expected({ triangles: NaN }, `${whole}NaN`);
  expected({ triangles: 2 ** 32 + 2000 }, `${whole}4294969296`);
  expected({ triangles: null }, `${whole}null`);
  expected({ triangles: 2000n }, `${whole}a bigint`);
  expected({ triangles: 10 }, /triangles is 10, expected 1000 to 1000000/);
  expected({ clips: 'walk' }, 'clips: expected an array of strings, found a string');
  expected({ clips: ['walk', 1] }, 'clips[1]: expected a string, found 1');
  expected({ clips: ['wlak'] }, /there is no clip "wlak", did you mean "walk"\?$/);
  expected({ name: '\ud800' }, /^options: the JSON text is invalid/);
  expected(null, 'options: expected an object, found null');
  expected(new Map([['triangles', 2000]]), 'options: expected an object, found a Map');
  expected(['walk'], 'options: expected an object, found an Array');
  const read = (options, message) =>
    refused(() => pelt.readCharacter(rock(), { name: 'rock', ...options }), message);
  read({ exclude: 'Cape' }, /^exclude: expected an array of strings/);
  read({ renormalise: 1 }, 'renormalise: expected true or false, found 1');
  read({ noUnskinned: 'yes' }, /^noUnskinned: expected true or false/);
  const nameless = "name: a character needs one, as in { name: 'knight' }";
  read({ name: undefined }, nameless);
  refused(() => pelt.readCharacter(rock()), nameless);
  refused(() => pelt.collide(a, b, { firstContact: 1 }), /^firstContact: expected true or false/);
});

test('options that are undefined are not there', () => {
  const plain = pelt.generateCreature({ triangles: 2000, joints: 30, seed: undefined });
  assert.deepEqual(plain.restPositions, creature.restPositions);
  plain.delete();
});

test('limits that are none are refused', () => {
  for (const maxContacts of [0, -1, NaN, 1.5, '3', 2 ** 32]) {
    refused(() => pelt.collide(a, b, { maxContacts }), /^maxContacts: expected a whole number from 1/);
  }
  assert.deepEqual(pelt.collide(a, b, { maxContacts: Infinity }).pairs, pelt.collide(a, b).pairs);
  for (const maxDistance of [NaN, -1, '1', null]) {
    refused(() => pelt.distance(a, b, { maxDistance }), /^maxDistance: expected a number from 0/);
  }
});

test('numbers and arrays that are none, or too short, are refused', () => {
  refused(() => a.cast([0, 1], [0, 0, 1]), 'origin: expected 3 numbers, found 2');
  refused(() => a.cast([0, 1, -5], [0, NaN, 1]), 'direction[1]: expected a finite number, found NaN');
  refused(() => a.cast([0, 1, -5], [0, 0, 1], { maxT: NaN }), /^maxT: expected a number/);
  refused(() => a.cast({ x: 0 }, [0, 0, 1]), 'origin: expected an array of 3 numbers, found an Object');
  refused(() => a.bounds(-1), /^levels: expected a whole number/);
  refused(() => a.nodeBoxes(-1), /^level: expected a whole number/);
  refused(() => a.nodeBoxes(), /^level: .*found nothing/);
  refused(() => creature.palette('walk'), 'seconds: expected a finite number, found nothing');
  refused(() => creature.palette(3, 0), 'clip: expected a string, found 3');
  refused(() => creature.palette('walk', 0, [1, 2]), 'placement: expected 16 numbers, found 2');
  refused(() => creature.palette('walk', 0, new Array(16).fill(NaN)), /^placement\[0\]: .*found NaN/);
  refused(() => a.setPalette(null), 'palette: expected an array of 480 numbers, found null');
  refused(() => a.setPalette(new Array(480).fill(null)), /^palette: expected an array of 480 numbers/);
  refused(() => a.setPalette(new BigInt64Array(480)), /^palette: expected an array of 480 numbers/);
  refused(() => a.posedVertices([]), /^out: expected a Float32Array of/);
});

test('contacts are a Uint32Array of whole pairs', () => {
  refused(() => pelt.describeContacts(a, b, [1, 2]), 'pairs: expected a Uint32Array, found an Array');
  refused(() => pelt.describeContacts(a, b, new Uint16Array(2)), /^pairs: expected a Uint32Array/);
  refused(() => pelt.describeContacts(a, b, new Uint32Array(3)), 'pairs: expected a multiple of 2 numbers, found 3');
  refused(() => pelt.describeContacts(a, b, Uint32Array.of(2000, 0)), /^pairs: a triangle number is out of range/);
  const hash = pelt.makeContactHash();
  refused(() => hash.add(0, 0, 1, new Uint32Array(3)), /^pairs: expected a multiple of 2/);
  refused(() => hash.add(NaN, 0, 1, new Uint32Array(2)), /^frame: expected a whole number/);
  refused(() => hash.addCrowd(0, new Uint32Array(6)), /^contacts: expected a multiple of 4/);
  hash.delete();
});

test('an object of another class is refused', () => {
  refused(() => pelt.collide(creature, b), 'a: expected a Pose, found a Character');
  refused(() => pelt.collide(a, { handle: 1024 }), 'b: expected a Pose, found an Object');
  refused(() => pelt.intersects(a), 'b: expected a Pose, found nothing');
  refused(() => pelt.makeCrowd().add(a), 'character: expected a Character, found a Pose');
  refused(() => pelt.makeScene({ characters: [a] }), /^parts\.characters\[0\]: expected a Character/);
});

test('an object of another engine is refused', async () => {
  const other = await loadPelt();
  const character = other.generateCreature({ triangles: 1000, joints: 20 });
  const pose = character.makePose();
  refused(() => pelt.collide(pose, b), 'a: it belongs to another engine');
  refused(() => other.distance(pose, b), 'b: it belongs to another engine');
  refused(() => pelt.makeCrowd().add(character), 'character: it belongs to another engine');
  refused(() => pelt.makeScene({ characters: [character] }), 'parts.characters[0]: it belongs to another engine');
});

test('what a character and a pose are made of cannot be changed', () => {
  assert.throws(() => { creature.jointCount = 1000; }, TypeError);
  assert.throws(() => { creature.morphTargetNames.push('smile'); }, TypeError);
  assert.throws(() => { a.character = {}; }, TypeError);
});

test('a file may be any bytes', () => {
  const bytes = rock();
  const buffer = bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength);
  for (const file of [bytes, buffer, new DataView(buffer), Buffer.from(bytes)]) {
    const character = pelt.readCharacter(file, { name: 'rock' });
    assert.equal(character.triangleCount, 4);
    character.delete();
  }
  refused(() => pelt.readCharacter('rock.glb', { name: 'rock' }),
          'file: expected a Uint8Array or an ArrayBuffer, found a string');
});

test('files are bytes by their paths', () => {
  const scene = { models: { rock: 'rock.gltf' }, instances: [] };
  const text = new TextEncoder().encode(JSON.stringify(scene));
  pelt.readScene('s.json', { 's.json': text.buffer, 'rock.gltf': rock().buffer }).delete();
  const files = (more, message) => refused(() => pelt.readScene('s.json', { 's.json': text, ...more }), message);
  files({ 'rock.gltf': 'text' }, 'files: rock.gltf: expected a Uint8Array or an ArrayBuffer, found a string');
  files({ a: text, 'a/b': text }, 'files: a is a folder, too');
  files({ 'a/b': text, a: text }, 'files: a is a folder, too');
  files({ '../a': text }, 'files: ../a leads out');
  refused(() => pelt.readScene('s.json'), 'files: expected an object, found nothing');
  refused(() => pelt.readScene('s.json\0x', {}), 'path: a path has no character 0');
  refused(() => pelt.readScene(7, {}), 'path: expected a string, found 7');
});

test('instances of a scene are checked, when it is made and when it is used', () => {
  const make = (instance) =>
    pelt.makeScene({ characters: [creature], instances: [{ character: 0, ...instance }] });
  const wrong = (instance, message) => refused(() => make(instance), message);
  wrong({ translatoin: [0, 0, 0] },
        'parts.instances[0]: unknown key "translatoin", did you mean "translation"?');
  wrong({ rotation: [0, 1, 0] }, 'parts.instances[0].rotation: expected 4 numbers, found 3');
  wrong({ rotation: [0, 0, 0, 0] }, /rotation: expected a quaternion, found one of length 0/);
  wrong({ scale: 0 }, /^parts\.instances\[0\]\.scale: expected a number from 0\.000001 to 1000000, found 0/);
  wrong({ start: NaN }, /\.start: .*found NaN/);
  wrong({ clip: 3 }, /\.clip: expected a string, found 3/);
  wrong({ morphWeights: { smile: '1' } }, /\.morphWeights\.smile: expected a number/);
  refused(() => pelt.makeScene({ characters: [creature], fps: 0 }), /^parts\.fps: /);
  refused(() => pelt.makeScene({ characters: creature }), 'parts.characters: expected an array, found a Character');
  const scene = make({ start: undefined, clip: 'walk' });
  assert.deepEqual(scene.palette(0, 3), creature.palette('walk', 0.1));
  scene.instances[0].velocity = [0, 0];
  refused(() => scene.palette(0, 3), 'instances[0].velocity: expected 3 numbers, found 2');
  scene.instances[0].velocity = [0, 0, 0];
  scene.instances[0].morphWeights = { smile: 1 };
  refused(() => scene.setPose(a, 0, 3), 'instances[0].morphWeights: there is no morph target "smile"');
  scene.instances[0].morphWeights = {};
  refused(() => scene.palette(0, NaN), 'frame: expected a finite number, found NaN');
  refused(() => scene.palette(1, 0), 'instance: the scene has no instance 1');
  scene.fps = 0;
  refused(() => scene.palette(0, 3), /^fps: expected a number from/);
});

test('parts that a scene was made of may be changed, which changes nothing in it', () => {
  const parts = { characters: [creature], instances: [{ character: 0, translation: [0, 0, 0] }] };
  const scene = pelt.makeScene(parts);
  const before = scene.palette(0, 0);
  parts.instances[0].translation[2] = 5;
  assert.deepEqual(scene.palette(0, 0), before);
  scene.instances[0].translation[2] = 5;
  assert.notDeepEqual(scene.palette(0, 0), before);
});

test('a pose that takes no palette keeps its morph weights', () => {
  const face = pelt.generateFace({ triangles: 1000 });
  const scene = pelt.makeScene({
    characters: [face],
    instances: [{ character: 0, velocity: [1e12, 0, 0], morphWeights: { jaw_open: 1 } }],
  });
  const pose = face.makePose();
  const other = face.makePose();
  pelt.intersects(pose, other);
  const [before, opened] = [pose.posedVertices(), pose.openedNodeCount];
  refused(() => scene.setPose(pose, 0, 1e9), /palette\[0\]/);
  assert.deepEqual(pose.posedVertices(), before);
  assert.equal(pose.openedNodeCount, opened);
  scene.setPose(pose, 0, 0);
  assert.notDeepEqual(pose.posedVertices(), before);
  for (const made of [pose, other, face]) made.delete();
});
