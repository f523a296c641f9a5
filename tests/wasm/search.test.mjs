/** Searches in slices: certain at any time, and at the end the answer of `collide`. */

import assert from 'node:assert/strict';
import test from 'node:test';
import { pelt, refused } from './support.mjs';

const scene = pelt.readScene('demo.json', {
  'demo.json': new TextEncoder().encode(pelt.demoScene),
});
const [a, b] = scene.instances.map(({ character }) => scene.characters[character].makePose());

function poseAt(frame) {
  [a, b].forEach((pose, i) => scene.setPose(pose, i, frame));
}

const keysOf = (pairs) =>
  Array.from({ length: pairs.length / 2 }, (_, i) => `${pairs[2 * i]} ${pairs[2 * i + 1]}`);

/** What a search says in the middle. */
const stateOf = (search) => [
  search.verdict,
  search.pairs(),
  search.undecidedPairs,
  search.resolution,
  search.distanceBound,
  search.workDone,
  search.longestStep,
  search.openRegions(),
];

for (const order of ['firstContact', 'resolution', 'contacts']) {
  test(`slices of a search in the order ${order} approach the answer of collide`, () => {
    poseAt(44);
    const expected = pelt.collide(a, b).pairs;
    const all = new Set(keysOf(expected));
    const search = pelt.makeSearch(a, b, { order, maxOpen: 500 });
    let [undecided, bound, known, slices] = [Infinity, Infinity, 0, 0];
    for (; !search.isComplete; ++slices) {
      search.run(3000);
      const keys = keysOf(search.pairs());
      assert.ok(keys.every((key) => all.has(key)) && keys.length >= known);
      assert.ok(search.undecidedPairs <= undecided && search.distanceBound <= bound);
      assert.ok(search.undecidedPairs >= all.size - keys.length);
      const { count, boxes, depths, pairCounts } = search.openRegions();
      assert.deepEqual([boxes.length, depths.length], [6 * count, count]);
      assert.equal(pairCounts.reduce((sum, pairs) => sum + pairs, 0), search.undecidedPairs);
      assert.equal(search.verdict, keys.length > 0 ? 'touching' : 'unknown');
      [undecided, bound, known] = [search.undecidedPairs, search.distanceBound, keys.length];
    }
    assert.ok(slices > 10, `${slices} slices`);
    assert.deepEqual(search.pairs(), expected);
    assert.deepEqual([search.undecidedPairs, search.resolution, search.distanceBound], [0, 0, 0]);
    search.delete();
  });
}

test('several slices are as good as one with the sum of their work', () => {
  poseAt(44);
  const [one, many] = [0, 1].map(() => pelt.makeSearch(a, b, { order: 'contacts' }));
  assert.equal(one.run(20000).cutShort, true);
  for (let i = 0; i < 20; ++i) many.run(1000);
  assert.deepEqual(stateOf(many), stateOf(one));
  assert.ok(one.pairs().length > 0 && one.workDone >= 20000);
  assert.equal(one.run(Infinity).cutShort, false);
  assert.ok(one.isComplete);
  one.delete();
  many.delete();
});

test('poses that are apart are so after little work', () => {
  poseAt(0);
  const search = pelt.makeSearch(a, b);
  search.run(Infinity);
  assert.deepEqual([search.verdict, search.pairs().length, search.isComplete], ['apart', 0, true]);
  assert.ok(search.distanceBound > 0);
  search.delete();
});

test('a search of poses that have changed is stale until it is restarted', () => {
  poseAt(30);
  const search = pelt.makeSearch(a, b, { order: 'contacts' });
  assert.equal(search.isStale, false);
  poseAt(44);
  assert.equal(search.isStale, true);
  assert.throws(() => search.run(10), {
    code: 'invalid_argument',
    message: 'a pose has changed since the search was started: call restart()',
  });
  search.restart();
  search.run(Infinity);
  assert.deepEqual(search.pairs(), pelt.collide(a, b).pairs);
  search.delete();
});

test('wrong arguments are refused, and so is a search without its poses', () => {
  refused(() => pelt.makeSearch(a, a), 'a and b: expected two different poses');
  refused(() => pelt.makeSearch(a, b, { order: 'fast' }), /^order: expected one of "firstContact", .*found "fast"/);
  refused(() => pelt.makeSearch(a, b, { maxOpen: 0 }), /^maxOpen: expected a whole number from 1/);
  refused(() => pelt.makeSearch(a, b, { orders: 'contacts' }), /did you mean "order"/);
  const other = b.character.makePose();
  const search = pelt.makeSearch(a, other);
  for (const budget of [-1, 0.5, NaN, '9', undefined]) {
    refused(() => search.run(budget), /^budget: expected a whole number from 0/);
  }
  other.delete();
  for (const use of [() => search.run(9), () => search.pairs(), () => search.restart(), () => search.verdict]) {
    refused(use, /pose of .* has been deleted/);
  }
  search.delete();
  refused(() => search.isComplete, /the search has been deleted/);
});
