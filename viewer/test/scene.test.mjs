// Where characters are placed, and under which names files are found; without a browser.

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
    const { arrange, usualArrangement } = await load('scene/arrange.ts');
    const characters = [character('body', 1.01), character('coat', 2.34)];
    assert.equal(usualArrangement(characters), 'together');
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

  const distance = (one, other) => Math.hypot(...one.map((value, i) => value - other[i]));
});

describe('the length of a scene', () => {
  test('follows its clips as long as it is theirs', async () => {
    const { arrange } = await load('scene/arrange.ts');
    const { changeInstance, changeFps } = await load('state/changes.ts');
    const characters = [character('body', 1), character('coat', 2)];
    const scene = arrange(characters, 'together');
    const state = { scene, characters, frame: 55 };
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
    const { sceneFile } = await load('scene/scene_file.ts');
    const characters = [character('coat.glb', 1), character('coat.glb', 2)];
    const { models, instances } = JSON.parse(
      sceneFile(arrange(characters, 'together'), characters),
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
