/** Whatever is handed over, is answered or refused in words: calls with arguments drawn by chance. */

import assert from 'node:assert/strict';
import test from 'node:test';
import { loadPelt, PeltError } from './support.mjs';

const kCalls = 4_000;
const kSeed = 12345;

/** Numbers below `end`, the same in each run. */
function dice(seed) {
  let state = seed;
  return (end) => {
    state = (state * 1103515245 + 12345) % 2 ** 31;
    return Math.floor((state / 2 ** 31) * end);
  };
}

function makeObjects(pelt) {
  const character = pelt.generateCreature({ triangles: 1000, joints: 20 });
  const scene = pelt.makeScene({ characters: [character], instances: [{ character: 0 }] });
  const [a, b] = [character.makePose(), character.makePose()];
  const crowd = pelt.makeCrowd();
  crowd.add(character);
  return [pelt, character, a, b, scene, crowd, pelt.makeContactHash(), pelt.makeContactTally()];
}

const kNumbers = [0, 1, -1, 2.5, NaN, Infinity, 1e300, 2 ** 32, 10n];
const kArrays = [
  [],
  [1, 2, 3],
  [undefined, 2, 3],
  new Array(16).fill(0),
  new Float32Array(3),
  new Float32Array(320),
  new Uint32Array(4),
  new BigInt64Array(2),
  new DataView(new ArrayBuffer(8)),
];
const kOthers = [
  undefined,
  null,
  true,
  '',
  'walk',
  Symbol('walk'),
  () => {},
  {},
  Object.create(null),
  new Map(),
  new Date(0),
  { firstContact: true },
  { maxContacts: 2 },
  { maxPairs: 2 },
  { triangles: 5 },
];

test('calls with anything are answered, or refused in words', async () => {
  const pelt = await loadPelt();
  const objects = makeObjects(pelt);
  const filter = objects[1].makeSelfFilter();
  const values = [...kNumbers, ...kArrays, ...kOthers, ...objects, filter];
  const throwDie = dice(kSeed);
  const draw = (array) => array[throwDie(array.length)];
  const ended = { answered: 0, refused: 0 };
  for (let call = 0; call < kCalls; ++call) {
    const object = draw(objects);
    const members = Object.getOwnPropertyDescriptors(Object.getPrototypeOf(object));
    const names = Object.keys(members).filter((name) => !/^(constructor|delete|generate)/.test(name));
    const { value, get } = members[draw(names)];
    const given = Array.from({ length: throwDie(4) }, () => draw(values));
    try {
      (value ?? get).apply(object, given);
      ++ended.answered;
    } catch (error) {
      assert.ok(error instanceof PeltError, `seed ${kSeed}, call ${call}: ${error.stack}`);
      ++ended.refused;
    }
    assert.equal(pelt.hasEnded, false, `seed ${kSeed}, call ${call}`);
  }
  assert.ok(ended.answered > 800 && ended.refused > 800, JSON.stringify(ended));
});
