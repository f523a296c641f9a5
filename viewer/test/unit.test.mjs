// Parts of the page that need no browser.

import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import path from 'node:path';
import { after, before, describe, test } from 'node:test';
import { closeSources, load, openSources, root } from './load.mjs';

before(openSources);
after(closeSources);

describe('turns around y', () => {
  const quaternion = (degrees) => {
    const half = (degrees * Math.PI) / 360;
    return [0, Math.sin(half), 0, Math.cos(half)];
  };

  test('are read from -180 to 180 degrees', async () => {
    const { turnOf } = await load('scene/scene.ts');
    for (const degrees of [-179, -90, 0, 30, 180]) {
      assert.ok(Math.abs(turnOf(quaternion(degrees)) - degrees) < 1e-9, `${degrees}`);
    }
    assert.ok(Math.abs(turnOf(quaternion(270)) + 90) < 1e-9);
  });

  test('are set whatever else a rotation does', async () => {
    const { turnOf, withTurn } = await load('scene/scene.ts');
    const leaning = [0.2, 0.1, -0.3, Math.sqrt(1 - 0.04 - 0.01 - 0.09)];
    for (const degrees of [-120, 0, 45]) {
      const turned = withTurn(leaning, degrees);
      assert.ok(Math.abs(turnOf(turned) - degrees) < 1e-9, `${turnOf(turned)}`);
      assert.ok(Math.abs(Math.hypot(...turned) - 1) < 1e-12);
    }
  });
});

describe("a report's files", () => {
  test('are the bytes that base64 stands for', async () => {
    const { decodeFiles } = await load('worker/cast.ts');
    const bytes = Uint8Array.from({ length: 256 }, (_, i) => i);
    const files = { 'a/b.bin': Buffer.from(bytes).toString('base64'), empty: '' };
    assert.deepEqual(decodeFiles(files), [
      { path: 'a/b.bin', bytes },
      { path: 'empty', bytes: new Uint8Array() },
    ]);
  });
});

describe('steps with contacts between frames', () => {
  const steps = [
    { step: 2, to: 3, only_between: 4, first: 0.7 },
    { step: 5, to: 6, only_between: 9, first: 0.1 },
    { step: 7, to: 8, only_between: 4, first: 0.9 },
  ];

  test('are listed with the most contacts first', async () => {
    const { betweenInWords, worstSteps } = await load('panels/between.tsx');
    const { stepsOf } = await load('report/report.ts');
    const known = stepsOf({ steps });
    assert.deepEqual(
      worstSteps(known).map(({ frame, first: { to } }) => [frame, to]),
      [
        [5, 6],
        [2, 3],
        [7, 8],
      ],
    );
    assert.equal(betweenInWords(known), '17 contacts between frames only, in 3 steps');
  });

  test('belong to a clip, and count from its start', async () => {
    const { reelOf } = await load('report/clips.ts');
    const scene = JSON.stringify({ instances: [{ clip: '*' }] });
    const verdict = { worse: null, gone: null, newly_held: null };
    const answer = {
      options: { frames: [0, 10, 1] },
      counts: new Array(10).fill(0),
      steps,
      touches: [],
      totals: {},
      verdict,
    };
    const clips = [
      { clip: 'a', first_frame: 0, frames: 5 },
      { clip: 'b', first_frame: 5, frames: 5 },
    ];
    const report = { scene: 's', files: { s: btoa(scene) }, clips, answer };
    const [a, b] = reelOf(report).clips.map((one) => one.report.answer.steps);
    assert.deepEqual(a, [steps[0]]);
    assert.deepEqual(b, [
      { ...steps[1], step: 0, to: 1 },
      { ...steps[2], step: 2, to: 3 },
    ]);
  });
});

describe('the tally of touches', () => {
  /** A character of 4 triangles, in two parts that follow two joints. */
  const character = {
    parts: [{ name: 'coat' }, { name: 'arm' }],
    jointNames: ['hip', 'hand'],
    jointCount: 2,
    triangleParts: Uint16Array.of(0, 0, 1, 1),
    triangleJoints: Uint16Array.of(0, 1, 1, 1),
  };

  test('is by instances, parts and joints, the most contacts first', async () => {
    const { TouchTally } = await load('worker/touches.ts');
    const tally = new TouchTally([character, character, character]);
    tally.addAll(0, Uint32Array.of(0, 1, 0, 0, 0, 1, 1, 2, 0, 1, 1, 3, 1, 2, 1, 2));
    tally.addAll(7, Uint32Array.of(0, 1, 1, 2, 0, 1, 1, 3, 0, 1, 1, 3));
    const place = ({ instance, part, joint }) => `${instance} ${part} ${joint}`;
    assert.deepEqual(
      tally.sorted().map(({ a, b, contacts, worst }) => [place(a), place(b), contacts, worst]),
      [
        ['0 coat hand', '1 arm hand', 5, { frame: 7, contacts: 3 }],
        ['0 coat hip', '1 coat hip', 1, { frame: 0, contacts: 1 }],
        ['1 coat hand', '2 arm hand', 1, { frame: 0, contacts: 1 }],
      ],
    );
  });
});

describe('contacts of a character with itself', () => {
  const character = {
    parts: [{ name: 'coat' }, { name: 'arm' }],
    jointNames: ['hip'],
    jointCount: 1,
    triangleParts: Uint16Array.of(1, 0, 0),
    triangleJoints: Uint16Array.of(0, 0, 0),
  };
  const contacts = Uint32Array.of(0, 0, 0, 1, 0, 0, 1, 2, 0, 1, 0, 0);

  test('have no sides: the tally puts places in order', async () => {
    const { TouchTally } = await load('worker/touches.ts');
    const tally = new TouchTally([character, character]);
    tally.addAll(0, contacts);
    assert.deepEqual(
      tally.sorted().map(({ a, b }) => `${a.instance} ${a.part}, ${b.instance} ${b.part}`),
      ['0 coat, 0 arm', '0 coat, 0 coat', '0 arm, 1 arm'],
    );
  });

  test('are found in a spot in any order', async () => {
    const { contactsInSpot } = await load('worker/close_ups.ts');
    const place = (part) => ({ instance: 0, part, joint: 'hip' });
    const spot = { a: place('coat'), b: place('arm') };
    assert.deepEqual([...contactsInSpot([character, character], contacts, spot)], [0, 0, 1, 0]);
  });

  test('are told from others by bodies', async () => {
    const { split } = await load('worker/scene_crowd.ts');
    const ofBodies = Uint32Array.of(1, 0, 0, 1, 0, 0, 1, 2, 2, 3, 0, 0);
    const { ofSelf, ofPairs } = split({ contacts, ofBodies });
    assert.deepEqual([...ofSelf], [0, 0, 1, 2]);
    assert.deepEqual([...ofPairs], [0, 0, 0, 1, 0, 1, 0, 0]);
    const { isOfSelf } = await load('state/listing.ts');
    const spot = { a: { instance: 0, part: 'coat' }, b: { instance: 0, part: 'arm' } };
    assert.equal(isOfSelf(spot, 'instance'), true);
    assert.equal(isOfSelf(spot, 'part'), false);
  });
});

describe('triangles in contact', () => {
  test('are gathered once each, by instances, also in the next frame', async () => {
    const { TriangleSets } = await load('worker/glow.ts');
    const sets = new TriangleSets([10, 10, 10]);
    const contacts = Uint32Array.of(0, 1, 3, 4, 0, 1, 3, 5, 0, 2, 3, 9);
    for (const round of [1, 2]) {
      assert.deepEqual(
        sets.gather(contacts).map((set) => [...set]),
        [[3], [4, 5], [9]],
        `${round}`,
      );
    }
    assert.deepEqual(
      sets.gather(new Uint32Array()).map((set) => [...set]),
      [[], [], []],
    );
  });

  test('come as corners and centres, with room for more', async () => {
    const { glowOf, roomFor } = await load('worker/glow.ts');
    const triangles = Uint32Array.of(0, 1, 2, 2, 1, 3);
    const positions = Float32Array.of(0, 0, 0, 3, 0, 0, 0, 3, 0, 3, 3, 3);
    const glow = glowOf(
      [{ triangles }, { triangles }],
      [{ positions }, { positions }],
      [Uint32Array.of(), Uint32Array.of(0)],
      [Uint32Array.of(1), Uint32Array.of(0)],
    );
    assert.deepEqual([glow.triangles, glow.ofSelf], [3, 1]);
    assert.deepEqual(
      [...glow.corners.subarray(9, 27)],
      [0, 3, 0, 3, 0, 0, 3, 3, 3, 0, 0, 0, 3, 0, 0, 0, 3, 0],
    );
    assert.deepEqual([...glow.corners.subarray(0, 9)], [...glow.corners.subarray(18, 27)]);
    assert.deepEqual([...glow.centres.subarray(0, 9)], [1, 1, 0, 2, 2, 1, 1, 1, 0]);
    assert.deepEqual([0, 64, 65, 1000].map(roomFor), [64, 64, 128, 1024]);
    assert.equal(glow.corners.length, 9 * 64);
  });
});

describe('contacts', () => {
  test('are seen from the sides on which nothing stands before them', async () => {
    const { seenFromSides } = await load('worker/close_ups.ts');
    const { SIDES } = await load('scene/sides.ts');
    const glow = {
      triangles: 2,
      centres: Float32Array.of(0, 0, 0, 5, 0, 0),
      corners: Float32Array.of(0, 0.5, 0, 0, 0, 0, 0, 0, 0, 5, 0.5, 0, 0, 0, 0, 0, 0, 0),
    };
    const wall = { castAny: ([x], [towards]) => x < 3 && towards > 0 };
    assert.deepEqual(
      seenFromSides([{ castAny: () => false }, wall], glow),
      SIDES.map(([x]) => (x > 0 ? 1 : 2)),
    );
    assert.ok(SIDES.some(([x]) => x > 0) && SIDES.some(([x]) => x < 0));
  });
});

describe('files that are read', () => {
  const file = (path) => ({ path, bytes: new Uint8Array() });
  const pelt = {
    readCharacter(_, { name }) {
      if (name.startsWith('torn')) throw new Error(`${name}: is torn`);
      return { name };
    },
  };

  test('are kept where they are good, and the others named', async () => {
    const { readCharacters } = await load('worker/cast.ts');
    const { characters, sources, refused } = readCharacters(
      pelt,
      ['torn.glb', 'coat.glb', 'notes.txt'].map(file),
    );
    assert.deepEqual(
      characters.map(({ name }) => name),
      ['coat.glb'],
    );
    assert.deepEqual(sources, ['coat.glb']);
    assert.deepEqual(refused, [{ path: 'torn.glb', message: 'torn.glb: is torn' }]);
  });

  test('are refused where none is good, or nothing can be read any more', async () => {
    const { readCharacters } = await load('worker/cast.ts');
    const torn = ['torn.glb', 'torn too.glb'].map(file);
    assert.throws(() => readCharacters(pelt, torn), /^Error: torn.glb: .*\ntorn too.glb: is torn$/);
    const mixed = ['coat.glb', 'torn.glb'].map(file);
    assert.throws(() => readCharacters({ ...pelt, hasEnded: true }, mixed), /is torn/);
  });
});

describe('boxes', () => {
  test('that overlap or meet make a pair', async () => {
    const { collidingPairs } = await load('worker/body_pairs.ts');
    const pose = (low, high) => ({ bounds: () => ({ box: { low, high } }) });
    const [a, b, c] = [
      pose([0, 0, 0], [1, 1, 1]),
      pose([1, 0, 0], [2, 1, 1]),
      pose([0, 0, 1.5], [2, 2, 2]),
    ];
    assert.deepEqual(collidingPairs([a, b, c]), [[a, b]]);
  });
});

describe('the chart', () => {
  test('shows the most of the frames that share a bar', async () => {
    const { mostOfEach } = await load('panels/chart.tsx');
    assert.deepEqual(mostOfEach([1, 5, 0, 0, 7], 2), [5, 0, 7]);
    assert.deepEqual(mostOfEach([], 3), []);
    const million = new Array(1_000_000).fill(1);
    assert.equal(mostOfEach(million, 500).length, 2000);
    assert.deepEqual(mostOfEach([null, 4, null, null], 2), [4, 0]);
  });

  test('hatches the bars without a checked frame', async () => {
    const { uncheckedRuns } = await load('panels/chart.tsx');
    assert.deepEqual(uncheckedRuns([2, 5, 1], 8, 1), [
      [0, 2],
      [5, 8],
    ]);
    assert.deepEqual(uncheckedRuns([0, 9, 3], 9, 1), [
      [1, 3],
      [4, 6],
      [7, 9],
    ]);
    assert.deepEqual(uncheckedRuns([3, 4, 1], 9, 2), [
      [0, 2],
      [4, 9],
    ]);
  });
});

describe('a panel', () => {
  test('is rendered anew when a fact changes that it has read, and only then', async () => {
    const { watch } = await load('panels/watch.ts');
    const Watched = watch(({ state }) => [state.frame, state.scene?.name]);
    const state = { frame: 3, scene: null, answer: 1 };
    const panel = new Watched({ state });
    panel.props = { state };
    const { type, props } = panel.render();
    assert.deepEqual(type(props), [3, undefined]);
    const changes = (change) => panel.shouldComponentUpdate({ state: { ...state, ...change } });
    assert.equal(changes({}), false);
    assert.equal(changes({ answer: 2 }), false);
    assert.equal(changes({ frame: 4 }), true);
    assert.equal(changes({ scene: { name: 'walk' } }), true);
  });
});

describe('what one can do', () => {
  const state = {
    scene: { frameCount: 9 },
    frame: 4,
    sweep: { counts: [0, 2, 1, 0, 3, 0, 0, 5, 0] },
  };

  test('frames follow each other in a circle', async () => {
    const { step } = await load('state/changes.ts');
    assert.equal(step(1)({ ...state, frame: 8 }).frame, 0);
    assert.equal(step(-1)({ ...state, frame: 0 }).frame, 8);
    assert.equal(step(1)(state).isPlaying, false);
  });

  test('jumps lead to where contacts begin, round the clip', async () => {
    const { jumpToContact } = await load('state/changes.ts');
    const jump = (frame, direction) => jumpToContact(direction)({ ...state, frame }).frame;
    assert.deepEqual(
      [0, 1, 4, 7].map((frame) => jump(frame, 1)),
      [1, 4, 7, 1],
    );
    assert.deepEqual(
      [1, 2, 5, 8].map((frame) => jump(frame, -1)),
      [7, 1, 4, 7],
    );
    assert.deepEqual(jumpToContact(1)({ ...state, sweep: { counts: [0, 0] } }), {});
  });
});

describe('who asks the worker', () => {
  /** An asker whose worker answers so, and its state. */
  async function askerOf(answer) {
    const { Asker } = await load('flow/asker.ts');
    const { Store } = await load('state/store.ts');
    const store = new Store({ problems: [], reading: 'coat.glb', hovered: null });
    return { store, asker: new Asker(store, { ask: answer }) };
  }

  test('changes the state by the answer', async () => {
    const { store, asker } = await askerOf(async () => 'arm');
    assert.equal(await asker.ask('cast', {}, (hovered) => ({ hovered })), 'arm');
    assert.equal(store.state.hovered, 'arm');
    assert.deepEqual(store.state.problems, []);
  });

  test('tells of a failure once, and goes on', async () => {
    const { store, asker } = await askerOf(async () => {
      throw new Error('no more memory');
    });
    for (const _ of [1, 2]) assert.equal(await asker.ask('cast', {}), undefined);
    assert.equal(store.state.problems.length, 1);
    assert.match(store.state.problems[0].message, /no more memory/);
  });
});

describe('costs', () => {
  const scene = {};
  const query = { maxContacts: null, clearance: null, budget: null };
  const shot = (frame) => ({ ...query, scene, frame, boxLevel: null });
  const answer = (frame, allVertices = 10) => ({ shot: shot(frame), work: { allVertices } });
  const costs = (microseconds) => ({
    onDemand: { microseconds },
    eager: { microseconds: 2 * microseconds },
  });

  /** A state for measuring costs, with the requests made so far; `reply` answers a request. */
  async function meterOf(state, reply) {
    const { Meter } = await load('flow/meter.ts');
    const { Store } = await load('state/store.ts');
    const store = new Store({
      scene,
      answer: null,
      costs: null,
      reading: null,
      isWorkOpen: true,
      ...state,
    });
    const asked = [];
    const ask = async (_, { id, shot: wanted }) => {
      asked.push({ id, frame: wanted.frame });
      return reply(asked.length, store);
    };
    new Meter(store, { ask });
    return { store, asked };
  }

  const passing = (milliseconds) => new Promise((done) => setTimeout(done, milliseconds));

  test('are of one frame, whichever is shown when they are known', async () => {
    const { store, asked } = await meterOf({ isPlaying: true }, (questions, { update }) => {
      update(() => ({ answer: answer(questions) })); // the scene goes on
      return questions < 3 ? null : costs(100);
    });
    store.update(() => ({ answer: answer(0) }));
    await passing(50);
    assert.deepEqual(
      asked,
      [1, 1, 1].map((id) => ({ id, frame: 0 })),
    );
    assert.equal(store.state.costs.shot.frame, 0);
    assert.equal(store.state.answer.shot.frame, 3);
    store.update(() => ({ reading: 'the end of the test' }));
  });

  test('are the least of several while the scene stands still', async () => {
    const times = [300, 100, 200];
    const { store } = await meterOf({ isPlaying: false }, (questions, { update }) => {
      if (questions === times.length) update(() => ({ reading: 'the end of the test' }));
      return costs(times[questions - 1]);
    });
    store.update(() => ({ answer: answer(5) }));
    await passing(700);
    assert.equal(store.state.costs.onDemand.microseconds, 100);
    assert.equal(store.state.costs.eager.microseconds, 200);
    assert.equal(store.state.costs.frames, 1);
  });

  test('are told by a mean while the scene plays, as single ones leap', async () => {
    const { store } = await meterOf({ isPlaying: true }, (questions, { update }) => {
      if (questions === 2) update(() => ({ reading: 'the end of the test' }));
      const single = costs(100);
      return questions === 1 ? single : { ...single, eager: { microseconds: 2000 } };
    });
    store.update(() => ({ answer: answer(0) }));
    await passing(50);
    assert.equal(store.state.costs.eager.microseconds, 200);
    store.update(() => ({ answer: answer(1) }));
    await passing(700);
    const { onDemand, eager, frames } = store.state.costs;
    assert.deepEqual([onDemand.microseconds, frames], [100, 2]);
    assert.ok(eager.microseconds > 200 && eager.microseconds < 1000);
  });

  test('are compared in words that say something', async () => {
    const { ratioInWords } = await load('panels/work_panel.tsx');
    assert.deepEqual([5.04, 1.02, 0.98, 0.5, 15.7].map(ratioInWords), [
      '5.0× faster',
      'as fast',
      'as fast',
      '2.0× slower',
      '16× faster',
    ]);
  });

  test('are not measured while the numbers are folded', async () => {
    const { store, asked } = await meterOf({ isPlaying: false, isWorkOpen: false }, () => costs(9));
    store.update(() => ({ answer: answer(0) }));
    await passing(20);
    assert.equal(asked.length, 0);
    store.update(() => ({ isWorkOpen: true }));
    await passing(20);
    assert.equal(asked.length, 1);
    store.update(() => ({ reading: 'the end of the test' }));
  });

  test('of very many vertices are not measured while the scene plays', async () => {
    const { store, asked } = await meterOf({ isPlaying: true }, () => costs(100));
    store.update(() => ({ answer: answer(0, 1_000_000) }));
    await passing(20);
    assert.equal(asked.length, 0);
    store.update(() => ({ answer: answer(1, 1_000_000), isPlaying: false }));
    await passing(20);
    assert.equal(asked.length, 1);
    store.update(() => ({ reading: 'the end of the test' }));
  });
});

describe('the folders of the sources', () => {
  /** Each runs without those after it. Types may come from anywhere, but in no circle. */
  const ORDER = [
    'theme',
    'words',
    'scene',
    'worker',
    'report',
    'state',
    'keys',
    'flow',
    'draw',
    'panels',
    'main',
  ];
  const sources = path.join(root, 'src');
  const floorOf = (file) => ORDER.indexOf(path.relative(sources, file).split(/[/.]/)[0]);

  const files = readdirSync(sources, { recursive: true })
    .filter((name) => /\.tsx?$/.test(name))
    .map((name) => path.join(sources, name));

  /** The files, without extensions, that a file imports: all of them, or only those it runs with. */
  function importsOf(file, { withTypes }) {
    const statement = /^(?:import|export) (type )?([^;']*?from )?'(\.[^'?]*)[^']*';/gm;
    const found = [];
    for (const [, type, names = '', target] of readFileSync(file, 'utf8').matchAll(statement)) {
      const isOfTypes =
        type || (/^{[^}]*} from $/.test(names) && !/[{,]\s*(?!type )\w/.test(names));
      if (target.endsWith('.css') || (isOfTypes && !withTypes)) continue;
      found.push(path.resolve(path.dirname(file), target));
    }
    return found;
  }

  test('need none that stands after them', () => {
    let crossings = 0;
    for (const file of files) {
      assert.ok(floorOf(file) >= 0, `${file} has no place in the order`);
      for (const needed of importsOf(file, { withTypes: false })) {
        assert.ok(floorOf(needed) <= floorOf(file), `${file} needs ${needed}`);
        crossings += floorOf(needed) < floorOf(file);
      }
    }
    assert.ok(crossings > 40, `${crossings} imports from other folders`);
  });

  test('import each other in no circle, not even types', () => {
    const imports = new Map(
      files.map((file) => [file.replace(/\.tsx?$/, ''), importsOf(file, { withTypes: true })]),
    );
    const done = new Set();
    const walk = (file, way) => {
      if (way.includes(file)) {
        const circle = [...way.slice(way.indexOf(file)), file];
        assert.fail(circle.map((one) => path.relative(sources, one)).join(' -> '));
      }
      if (done.has(file)) return;
      assert.ok(imports.has(file), `${way.at(-1)} imports ${file}, which is not there`);
      for (const needed of imports.get(file)) walk(needed, [...way, file]);
      done.add(file);
    };
    for (const file of imports.keys()) walk(file, []);
    const count = [...imports.values()].flat().length;
    assert.ok(count > 300, `${count} imports`);
  });
});
