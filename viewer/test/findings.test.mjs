// The findings that a report derives from its answer, without a browser.

import assert from 'node:assert/strict';
import { after, before, describe, test } from 'node:test';
import { closeSources, load, openSources } from './load.mjs';

before(openSources);
after(closeSources);

const answerOf = (counts, frames, verdict = {}) => ({
  options: { frames, by: 'instance', max_contacts: null, clearance: null },
  counts,
  totals: { frames: counts.length, frames_in_contact: counts.filter((count) => count > 0).length },
  touches: [],
  verdict: { worse: null, gone: null, newly_held: null, ...verdict },
});

describe('numbers', () => {
  test('stand with their nouns, as the command has them', async () => {
    const { counted } = await load('words.ts');
    assert.deepEqual(
      [0, 1, 1279].map((count) => counted(count, 'frame')),
      ['0 frames', '1 frame', '1,279 frames'],
    );
  });
});

describe('the headline', () => {
  const cases = [
    [answerOf([0, 3, 5, 5], [0, 4, 1]), 'Contact in 3 of 4 frames', { frame: 2, contacts: 5 }],
    [answerOf([1, 0, 7], [2, 9, 3]), 'Contact in 2 of 3 frames', { frame: 8, contacts: 7 }],
    [answerOf([0, 0], [0, 2, 1]), 'No contact in 2 frames', null],
    [answerOf([4], [45, 46, 1]), 'Contact in frame 45', { frame: 45, contacts: 4 }],
    [answerOf([0], [0, 1, 1]), 'No contact in frame 0', null],
    [answerOf([0, 0], [0, 2, 1], { pairs_compared: 0 }), 'Nothing was compared', null],
    [answerOf([0], [0, 1, 1], { pairs_compared: 1 }), 'No contact in frame 0', null],
  ];
  for (const [answer, words, worst] of cases) {
    test(`is "${words}"`, async () => {
      const { headlineOf, worstFrame } = await load('report/verdict.ts');
      assert.equal(headlineOf(answer), words);
      assert.deepEqual(worstFrame(answer), worst);
    });
  }
});

describe('beside a baseline', () => {
  const place = (instance, joint) => ({ instance, part: 'skin', joint });
  const touch = (a, b, contacts) => ({ a: place(0, a), b: place(1, b), contacts });
  const grown = { ...touch('hand', 'hip', 90), worst: { frame: 3, contacts: 84 }, known: 83 };
  const fresh = { ...touch('foot', 'foot', 2), worst: { frame: 9, contacts: 2 }, known: 0 };
  const touches = [touch('head', 'head', 500), touch('hand', 'hip', 90), touch('foot', 'foot', 2)];
  const verdict = { worse: [grown, fresh], gone: [{}], newly_held: [{}, {}] };
  const report = { answer: { ...answerOf([5], [0, 1, 1], verdict), touches } };
  const scene = { instances: [{ character: 0 }, { character: 1 }] };
  const frames = report.answer.options.frames;
  const asked = {
    maxContacts: null,
    clearance: null,
    budget: null,
    between: false,
    by: 'instance',
    frames,
    self: {},
    characters: [],
  };
  const state = { ...asked, report, reported: scene, scene };

  test('touches are counted as the command counts them', async () => {
    const { comparisonOf } = await load('report/baseline.ts');
    const numbers = { fresh: 1, grown: 1, known: 1, gone: 1, newlyHeld: 2 };
    assert.deepEqual(comparisonOf(report.answer), numbers);
    assert.equal(comparisonOf(answerOf([5], [0, 1, 1])), null);
  });

  test('those that are new come first, then those that have grown', async () => {
    const { worstFirst, worseTouch } = await load('report/baseline.ts');
    const sorted = worstFirst(touches, state);
    assert.deepEqual(
      sorted.map(({ a }) => a.joint),
      ['foot', 'hand', 'head'],
    );
    const [, { a, b }] = sorted;
    assert.equal(worseTouch({ a, b }, state), grown);
    assert.equal(worseTouch({ a: b, b: a }, state), grown, 'in no order');
  });

  test('the list can be restricted to words, a pair and a standing', async () => {
    const { filtered } = await load('state/listing.ts');
    const { NO_FILTER } = await load('state/state.ts');
    const characters = [{ name: 'Knight' }, { name: 'Horse' }];
    const listed = (filter) => {
      const full = { ...state, characters };
      const found = filtered(touches, { ...full, filter: { ...NO_FILTER, ...filter } });
      return found.map(({ a }) => a.joint).join();
    };
    assert.equal(listed({}), 'head,hand,foot');
    assert.equal(listed({ words: 'HAND horse' }), 'hand');
    assert.equal(listed({ words: 'knight foot skin 1 ' }), 'foot');
    assert.equal(listed({ words: 'tail' }), '');
    assert.equal(listed({ pair: [0, 1] }), 'head,hand,foot');
    assert.equal(listed({ pair: [1, 2] }), '');
    assert.equal(listed({ standing: 'new' }), 'foot');
    assert.equal(listed({ standing: 'grown' }), 'hand');
    assert.equal(listed({ standing: 'known', words: 'head' }), 'head');
  });

  test('nothing is said of another scene than the one compared', async () => {
    const { worstFirst, worseTouch } = await load('report/baseline.ts');
    for (const changed of [
      { ...state, scene: { ...scene } },
      { ...state, frames: null },
      { ...state, self: { wanted: 'also' } },
    ]) {
      assert.equal(worseTouch(touches[1], changed), null);
      assert.deepEqual(worstFirst(touches, changed), touches);
    }
  });
});

test('nothing is compared unless two instances or parts are there', async () => {
  const { whyNothingIsCompared } = await load('state/shots.ts');
  const characters = [{ partCount: 1 }, { partCount: 2 }];
  const reason = (by, ...cast) => {
    const scene = { instances: cast.map((character) => ({ character })) };
    return whyNothingIsCompared({ scene, characters, by, self: { wanted: 'off' } });
  };
  const alone = { scene: { instances: [{ character: 0 }] }, characters, by: 'instance', self: {} };
  assert.equal(whyNothingIsCompared(alone), null, 'it is tested against itself');
  assert.equal(reason('instance', 1), 'the scene has fewer than two characters, and “self” is off');
  assert.equal(reason('instance', 0, 0), null);
  assert.equal(reason('part', 0), 'the scene has fewer than two parts, and “self” is off');
  assert.equal(reason('part', 1), null);
  assert.equal(reason('part', 0, 0), null);
});
