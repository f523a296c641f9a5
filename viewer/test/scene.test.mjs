// Default placements of characters, and the names under which files are found; without a browser.

import assert from 'node:assert/strict';
import { after, before, describe, test } from 'node:test';
import { closeSources, load, openSources } from './load.mjs';

before(openSources);
after(closeSources);

/** A character 1.8 high and 1.6 wide. */
const character = (name, seconds) => ({
  name,
  source: name,
  clips: [
    { name: 'run', seconds: 0.5 },
    { name: 'Walk', seconds },
  ],
  extent: { low: [-0.8, 0, -0.2], high: [0.8, 1.8, 0.2] },
});

describe('characters without a scene', () => {
  test('stand together for all of the longest clip, at 30 frames a second', async () => {
    const { arrange } = await load('scene/arrange.ts');
    const characters = [character('body', 1.01), character('coat', 2.34)];
    const { instances, frameCount, fps } = arrange(characters, 'together');
    assert.deepEqual([frameCount, fps], [71, 30]);
    assert.deepEqual(
      instances.map(({ clip, translation, velocity }) => [clip, ...translation, ...velocity]),
      [0, 1].map(() => ['Walk', 0, 0, 0, 0, 0, 0]),
    );
  });

  test('walk in from a circle on which all have room', async () => {
    const { arrange } = await load('scene/arrange.ts');
    const { placeAt } = await load('scene/scene.ts');
    const { instances, frameCount } = arrange(
      Array.from({ length: 20 }, (_, i) => character(`${i}`, 1)),
      'walking',
    );
    assert.equal(frameCount, 90);
    instances.forEach(({ translation }, i) => {
      const next = instances[(i + 1) % 20].translation;
      assert.ok(distance(translation, next) > 1.6, `${i} stands in its neighbour`);
    });
    const meeting = instances.map((instance) => placeAt(instance, 2));
    assert.ok(
      meeting.every((place) => distance(place, [0, 0, 0]) < 0.2),
      'in the middle',
    );
  });

  test('pass each other within the width of the narrowest', async () => {
    const { arrange } = await load('scene/arrange.ts');
    const horse = { low: [-0.25, 0, -1.3], high: [0.25, 1.8, 1.3] };
    const dog = { low: [-0.1, 0, -0.4], high: [0.1, 0.6, 0.4] };
    const cast = [horse, dog].map((extent) => ({ ...character('', 1), extent }));
    const { instances } = arrange(cast, 'walking');
    const [first, second] = instances.map(({ translation }) => translation[0]);
    assert.ok(Math.abs(first - second) < 0.2, `${first} and ${second}`);
  });

  test('are joined by others on their way to the middle, and nobody is moved', async () => {
    const { arrange, join } = await load('scene/arrange.ts');
    const { placeAt } = await load('scene/scene.ts');
    const characters = [character('a', 1), character('b', 1), character('c', 1)];
    const two = arrange(characters.slice(0, 2), 'walking');
    const three = join(two, characters, 2, 'walking');
    assert.equal(three.name, 'a, b, c');
    assert.deepEqual(three.instances.slice(0, 2), two.instances);
    const [, , third] = three.instances;
    assert.ok(distance(third.translation, [0, 0, 0]) > 1, 'from the circle');
    assert.ok(
      two.instances.every(({ translation }) => distance(translation, third.translation) > 1),
      'from between the others',
    );
    assert.ok(distance(placeAt(third, 2), [0, 0, 0]) < 0.2, 'in the middle');
  });

  test('are joined in one place where they stand in one', async () => {
    const { arrange, join } = await load('scene/arrange.ts');
    const characters = [character('body', 1), character('coat', 2)];
    const dressed = join(arrange(characters.slice(0, 1), 'together'), characters, 1, 'together');
    assert.deepEqual(dressed.instances.at(-1).translation, [0, 0, 0]);
    assert.deepEqual(dressed.instances.at(-1).velocity, [0, 0, 0]);
    assert.equal(dressed.frameCount, 60, 'as long as the longest clip');
  });

  const distance = (one, other) => Math.hypot(...one.map((value, i) => value - other[i]));
});

describe('characters that come one after the other', () => {
  test('walk with one that stood alone, unless that was edited', async () => {
    const { open } = await load('state/changes.ts');
    const { add } = await load('state/edits.ts');
    const { changeInstance } = await load('state/edits.ts');
    const { initialState: state } = await load('state/state.ts');
    const opened = { characters: [character('a', 1)], scene: null, self: {}, refused: [] };
    const alone = { ...state, ...open(opened)(state) };
    const [one, ...others] = alone.scene.instances;
    assert.deepEqual([one.velocity, others], [[0, 0, 0], []]);
    assert.equal(alone.scene.frameCount, 30, 'as long as the clip');
    const added = { characters: [character('b', 1)], refused: [] };
    const both = add(added)(alone);
    assert.deepEqual(
      both.scene.instances.map((instance) => instance.character),
      [0, 1],
    );
    assert.ok(both.scene.instances[0].velocity.some((speed) => speed !== 0));
    assert.equal(both.selected, 1);
    const edited = { ...alone, ...changeInstance(0, { scale: 2 })(alone) };
    assert.deepEqual(add(added)(edited).scene.instances[0], edited.scene.instances[0]);
    const three = add({ characters: [character('c', 1)], refused: [] })({ ...alone, ...both });
    assert.equal(three.scene.instances.length, 3);
  });

  test('stand beside all of a scene that was opened', async () => {
    const { add } = await load('state/edits.ts');
    const { arrange } = await load('scene/arrange.ts');
    const characters = [character('a', 1)];
    const opened = { ...arrange(characters, 'walking'), name: 'duel.json' };
    const { initialState } = await load('state/state.ts');
    const state = { ...initialState, characters, opened, scene: opened, arrangement: 'opened' };
    const refused = [{ path: 'torn.glb', message: 'is torn' }];
    const { scene, opened: kept, problems } = add({ characters, refused })(state);
    assert.equal(scene.instances.length, 2);
    assert.deepEqual(scene.instances[0], opened.instances[0]);
    assert.equal(kept.instances.length, 2);
    assert.deepEqual(problems, [{ title: 'torn.glb was left out', message: 'is torn' }]);
  });
});

describe('edits', () => {
  /** Two characters that walk, and functions that change them. */
  async function stage() {
    const changes = await load('state/changes.ts');
    const edits = await load('state/edits.ts');
    const history = await load('state/history.ts');
    const { initialState } = await load('state/state.ts');
    const opening = {
      characters: [character('a', 1), character('b', 1)],
      scene: null,
      self: {},
      refused: [],
    };
    const state = { ...initialState, ...changes.open(opening)(initialState) };
    const after = (begin, ...all) =>
      all.reduce((now, change) => ({ ...now, ...change(now) }), begin);
    return { ...changes, ...edits, ...history, state, after };
  }

  test('are undone and redone one by one, and steps of a drag are one', async () => {
    const { state, after, changeInstance, changeFps, endEdit, undo, redo } = await stage();
    const to = (x) => changeInstance(0, { translation: [x, 0, 0] });
    const edited = after(state, to(1), to(2), endEdit, to(3), changeFps(60));
    assert.equal(edited.past.length, 3);
    const back = [1, 2, 3, 4].map((count) => after(edited, ...new Array(count).fill(undo)));
    assert.deepEqual(
      back.map(({ scene }) => [scene.fps, scene.instances[0].translation[0]]),
      [
        [30, 3],
        [30, 2],
        [30, state.scene.instances[0].translation[0]],
        [30, state.scene.instances[0].translation[0]],
      ],
    );
    assert.equal(back[3].scene, state.scene, 'the same scene, which a report knows again');
    assert.equal(after(back[3], redo, redo, redo, redo).scene, edited.scene);
    assert.deepEqual(after(back[1], to(9)).future, []);
  });

  test('remove all but one, and copy', async () => {
    const { state, after, removeInstance, duplicateInstance, toggleHidden, undo } = await stage();
    const alone = after(state, toggleHidden(1), removeInstance(0));
    assert.deepEqual([alone.scene.name, ...alone.hidden], ['b', 0]);
    assert.equal(after(alone, removeInstance(0)).scene, alone.scene, 'the last one stays');
    assert.deepEqual([...after(alone, undo).hidden], [1]);
    const copied = after(state, duplicateInstance(0));
    const [original, , copy] = copied.scene.instances;
    assert.equal(copied.selected, 2);
    assert.equal(copy.character, original.character);
    assert.ok(copy.translation[0] - original.translation[0] > 1.6, 'beside it');
  });

  test('leave the placement to be chosen again, for those who are there', async () => {
    const { state, after, duplicateInstance, removeInstance, rearrange } = await stage();
    assert.equal(state.scene, state.arranged);
    const copied = after(state, duplicateInstance(0), removeInstance(1));
    assert.notEqual(copied.scene, copied.arranged);
    const placed = after(copied, rearrange('walking'));
    assert.equal(placed.scene, placed.arranged);
    assert.deepEqual(
      placed.scene.instances.map((instance) => instance.character),
      [0, 0],
    );
  });
});

describe('what the page has chosen', () => {
  test('is told as long as it is so', async () => {
    const { arrange, notesOn } = await load('scene/arrange.ts');
    const two = [character('a', 1), { ...character('b', 1), clips: [{ name: 'run', seconds: 1 }] }];
    const scene = arrange(two, 'walking');
    const [clips, ...rest] = notesOn(scene, two);
    assert.match(clips, /“Walk”, “run”/);
    assert.deepEqual(rest, []);
    scene.instances[1].clip = null;
    assert.deepEqual(notesOn(scene, two), []);
  });
});

describe('characters of very different sizes', () => {
  test('are named, as long as they are so', async () => {
    const { arrange, notesOn } = await load('scene/arrange.ts');
    const small = { low: [-0.04, 0, -0.01], high: [0.04, 0.09, 0.01] };
    const cast = [character('dragon', 1), { ...character('fly', 1), extent: small }];
    const scene = arrange(cast, 'walking');
    const [note] = notesOn(scene, cast);
    assert.match(note, /^dragon is 20 times as large as fly: change “scale”/);
    scene.instances[1].scale = 10;
    assert.ok(!notesOn(scene, cast).some((text) => text.includes('times as large')));
  });
});

describe('the command with the same numbers', () => {
  const nothing = {
    by: 'instance',
    maxContacts: null,
    clearance: null,
    budget: null,
    between: false,
    self: {},
    readingOptions: {},
  };

  test('names the models where it places them so', async () => {
    const { arrange } = await load('scene/arrange.ts');
    const { checkCommand } = await load('scene/command.ts');
    const characters = [character('body.glb', 1), character("a knight's coat.glb", 1)];
    const scene = arrange(characters, 'together');
    scene.instances[1].clip = null;
    const { words, needsFile } = checkCommand({ ...nothing, scene, characters, by: 'part' });
    const coat = "'a knight'\\''s coat.glb'";
    assert.equal(words, `pelt check body.glb ${coat} --clip Walk --clip - --by part`);
    assert.equal(needsFile, false);
  });

  test('names the saved scene everywhere else', async () => {
    const { arrange } = await load('scene/arrange.ts');
    const { checkCommand } = await load('scene/command.ts');
    const characters = [character('body.glb', 1), character('coat.glb', 1)];
    const together = arrange(characters, 'together');
    const [first, second] = together.instances;
    const others = [
      arrange(characters, 'walking'),
      { ...together, fps: 60, frameCount: 60 },
      { ...together, frameCount: 7 },
      { ...together, ignore: [['hat', 'head']] },
      { ...together, instances: [first, { ...second, speed: 2 }] },
      { ...together, instances: [first, { ...second, rotation: [0, 1, 0, 0] }] },
      { ...together, instances: [first, { ...second, morphWeights: { smile: 1 } }] },
    ];
    const source = { file: 'coat.glb', skinning: 'dual-quaternion' };
    const skinned = [characters[0], { ...characters[1], source }];
    assert.equal(
      checkCommand({ ...nothing, scene: together, characters: skinned }).needsFile,
      true,
    );
    for (const scene of others) {
      const readingOptions = { renormalise: true, exclude: ['hat'] };
      const asking = { ...nothing, scene, characters, readingOptions, maxContacts: 1 };
      assert.deepEqual(checkCommand(asking), {
        words: 'pelt check scene.json --first --renormalise --exclude hat',
        needsFile: true,
      });
      const { words } = checkCommand({ ...asking, maxContacts: 12, clearance: 0.02 });
      assert.match(words, /^pelt check scene\.json --max-contacts 12 --clearance 0\.02 /);
      const timed = checkCommand({ ...asking, maxContacts: null, budget: 500, between: true });
      assert.match(timed.words, /^pelt check scene\.json --budget 500 --between /);
      const dual = { skinning: 'dual-quaternion' };
      const { words: skinned } = checkCommand({ ...asking, readingOptions: dual });
      assert.equal(skinned, 'pelt check scene.json --first --skinning dual-quaternion');
    }
  });
});

describe('contacts of characters with themselves', () => {
  const one = [{ ...character('a', 1), partCount: 2 }];
  const two = [...one, character('b', 1)];

  /** Arguments of the functions of scene/self.ts. */
  async function asking(characters, change = {}) {
    const { arrange } = await load('scene/arrange.ts');
    const scene = arrange(characters, 'walking');
    return { scene, characters, by: 'instance', self: {}, ...change };
  }

  test('count for a character that is alone, and by choice for several', async () => {
    const { wantedSelf, selfQuestion } = await load('scene/self.ts');
    assert.equal(wantedSelf(await asking(one)), 'also');
    assert.equal(wantedSelf(await asking(one, { by: 'part' })), 'off', 'of two parts');
    assert.equal(wantedSelf(await asking(two)), 'off');
    assert.equal(selfQuestion(await asking(two), null), null);
    const only = await asking(two, { self: { wanted: 'only' } });
    assert.deepEqual(selfQuestion(only, [0, 9, 1]), {
      isOnly: true,
      rings: 5,
      dropsAtRest: true,
      always: null,
      dropsNearJoints: true,
      frames: null,
    });
    const always = await asking(two, { self: { wanted: 'only', always: 0.9 } });
    assert.deepEqual(selfQuestion(always, [0, 9, 1]).frames, [0, 9, 1]);
  });

  test('at rest are kept where nothing moves', async () => {
    const { selfRules } = await load('scene/self.ts');
    const still = await asking([{ ...one[0], clips: [] }]);
    assert.equal(selfRules(still).dropsAtRest, false);
    assert.equal(selfRules(await asking(one)).dropsAtRest, true);
  });

  test('are asked by words of the command and keys of a scene', async () => {
    const { selfKeys, selfWords } = await load('scene/self.ts');
    const keys = {
      self: 'only',
      self_rings: 1,
      self_at_rest: 'keep',
      self_always: 0.95,
      self_near_joints: 'keep',
    };
    const self = {
      wanted: 'only',
      rings: 1,
      dropsAtRest: false,
      always: 0.95,
      dropsNearJoints: false,
    };
    assert.deepEqual(selfKeys(self), keys);
    const words =
      '--self=only --self-rings 1 --self-at-rest keep --self-always 0.95 --self-near-joints keep';
    assert.equal(selfWords(await asking(two, { self })).join(' '), words);
    assert.deepEqual(JSON.parse(JSON.stringify(selfKeys({}))), {});
    assert.deepEqual(selfKeys({ wanted: 'off', always: null }).self_always, 'keep');
    assert.deepEqual(selfWords(await asking(one)), []);
    assert.deepEqual(selfWords(await asking(one, { self: { wanted: 'off' } })), ['--self=no']);
    assert.deepEqual(selfWords(await asking(two, { self: { wanted: 'also' } })), ['--self']);
    assert.deepEqual(selfWords(await asking(two, { self: { rings: 1 } })), [], 'while it is off');
  });
});

describe('the sides of a scene', () => {
  test('are directions, the usual one first', async () => {
    const { SIDES } = await load('scene/sides.ts');
    assert.equal(SIDES.length, 8);
    for (const side of SIDES) assert.ok(Math.abs(Math.hypot(...side) - 1) < 1e-12);
    assert.equal(new Set(SIDES.map(([x]) => x.toFixed(3))).size, 8);
  });

  test('are changed only where another one shows much more', async () => {
    const { SIDES, betterSide } = await load('scene/sides.ts');
    assert.equal(betterSide([10, 12, 0, 0, 0, 0, 0, 20]), SIDES[0]);
    assert.equal(betterSide([10, 12, 0, 0, 0, 0, 0, 21]), SIDES[7]);
    assert.equal(betterSide([0, 0, 0, 0, 0, 0, 0, 0]), SIDES[0]);
    const present = SIDES[7].map((value) => value + 0.1);
    assert.equal(betterSide([10, 0, 0, 0, 0, 0, 0, 9], present), present);
  });
});

describe('the length of a scene', () => {
  test('follows its clips as long as it is theirs', async () => {
    const { arrange } = await load('scene/arrange.ts');
    const { changeInstance, changeFps } = await load('state/edits.ts');
    const characters = [character('body', 1), character('coat', 2)];
    const scene = arrange(characters, 'together');
    const { initialState } = await load('state/state.ts');
    const state = { ...initialState, scene, characters, frame: 55 };
    const ran = changeInstance(1, { clip: 'run' })(state);
    assert.deepEqual([ran.scene.frameCount, ran.frame], [30, 29]);
    assert.equal(changeFps(24)(state).scene.frameCount, 48);
    const cut = { ...state, scene: { ...scene, frameCount: 7 } };
    assert.equal(changeInstance(1, { clip: 'run' })(cut).scene.frameCount, 7);
  });
});

describe('a saved scene', () => {
  test('tells characters of the same name apart', async () => {
    const { arrange } = await load('scene/arrange.ts');
    const { sceneFile } = await load('scene/command.ts');
    const characters = [character('coat.glb', 1), character('coat.glb', 2)];
    const { models, instances } = JSON.parse(
      sceneFile(arrange(characters, 'together'), characters, {}),
    );
    assert.deepEqual(Object.keys(models), ['coat.glb', 'coat.glb (2)']);
    assert.deepEqual(
      instances.map(({ model }) => model),
      Object.keys(models),
    );
  });
});

describe('files of a scene', () => {
  const file = (path, content = path) => ({ path, bytes: new TextEncoder().encode(content) });
  const named = (models, uri) => [
    JSON.stringify({ models }),
    JSON.stringify({ buffers: [{ uri }, { uri: 'data:,x' }, {}] }),
  ];

  test('are found in their folders, by escaped names, too', async () => {
    const { filesOfScene } = await load('worker/find_files.ts');
    const [scene, gltf] = named({ coat: '../models/./coat.gltf', made: {} }, 'its%20data/coat.bin');
    const { path, files } = filesOfScene('show/scenes/a.json', [
      file('show/scenes/a.json', scene),
      file('show/models/coat.gltf', gltf),
      file('show/models/its data/coat.bin', 'right'),
      file('show/old/coat.bin', 'wrong'),
    ]);
    const model = path.replace('scenes/a.json', 'models/');
    assert.equal(new TextDecoder().decode(files.get(`${model}its data/coat.bin`)), 'right');
    assert.ok(files.has(`${model}coat.gltf`));
  });

  test('are found in models with options', async () => {
    const { filesOfScene } = await load('worker/find_files.ts');
    const models = { coat: { file: 'coat.glb', skinning: 'linear' }, odd: { file: 3 }, none: null };
    const { files } = filesOfScene('a.json', [file('a.json', named(models)[0]), file('coat.glb')]);
    assert.deepEqual([...files.keys()], ['a.json', 'coat.glb']);
  });

  test('keep their options under another name', async () => {
    const { fileOf, withFile } = await load('scene/scene.ts');
    const dual = { file: 'coat.glb', skinning: 'dual-quaternion' };
    const made = { creature: { triangles: 1000, joints: 20, seed: 1 }, skinning: 'linear' };
    assert.deepEqual(['hat.glb', dual, made].map(fileOf), ['hat.glb', 'coat.glb', null]);
    assert.equal(withFile('hat.glb', 'b.glb'), 'b.glb');
    assert.deepEqual(withFile(dual, 'b.glb'), { ...dual, file: 'b.glb' });
  });

  test('or else by their names, where only one has it', async () => {
    const { filesOfScene } = await load('worker/find_files.ts');
    const [scene, gltf] = named(
      { coat: '../../models/coat.gltf', hat: 'hat.glb' },
      'data/coat.bin',
    );
    const dropped = [
      file('a.json', scene),
      file('coat.gltf', gltf),
      file('coat.bin'),
      file('1/hat.glb'),
      file('2/hat.glb'),
    ];
    const { path, files } = filesOfScene('a.json', dropped);
    assert.ok(path.endsWith('a.json') && path.split('/').length >= 3, 'no name leads out');
    assert.equal(files.size, 3);
    assert.ok([...files.keys()].some((name) => name.endsWith('models/data/coat.bin')));
  });
});
