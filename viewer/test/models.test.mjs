// Drops, places and edits skinned, animated characters of all kinds, and compares with the command.

import assert from 'node:assert/strict';
import path from 'node:path';
import { after, before, describe, test } from 'node:test';
import * as browsing from './browser.mjs';
import { check, checkFiles } from './command.mjs';
import { character, compressed, inTwoFiles, inTwoParts, withLightWeights } from './models.mjs';

const { answered, counted, dropFiles, fact, goToFrame, number, pixels, savedScene } = browsing;
const built = path.resolve(process.env.PELT_PAGE ?? 'dist/index.html');

const [body, coat] = [character('body'), character('coat')];
const files = { 'body.glb': body, 'coat.glb': coat };

let browser, page;
before(async () => {
  browser = await browsing.launch();
  page = await browsing.openPage(browser, browsing.urlOf(built), { reducedMotion: 'reduce' });
});
after(() => browser.close());

async function drop(dropped) {
  await dropFiles(page, dropped);
  const [{ name }] = dropped;
  await page.waitForSelector(`.subject:has-text("${name}"):not(:has-text("reading"))`);
  await counted(page);
}

/** Counts the changes after which the page shows these words, until the result is requested. */
async function watchFor(words) {
  await page.evaluate((words) => {
    window.timesSaid = 0;
    new MutationObserver(() => {
      if (document.body.innerText.includes(words)) ++window.timesSaid;
    }).observe(document.body, { childList: true, characterData: true, subtree: true });
  }, words);
  return () => page.evaluate(() => window.timesSaid);
}

async function agreesWith({ counts, hash }) {
  await counted(page);
  assert.equal(await fact(page, 'hash'), hash);
  const frame = await number(page, 'frame');
  await answered(page, frame);
  assert.equal(await number(page, 'contacts'), counts[frame]);
}

test('two that are dropped walk in, and the page says what it has chosen', async (t) => {
  await page.getByRole('button', { name: 'whole clip' }).click();
  const rashWords = await watchFor('Nothing touches');
  await drop([
    { name: 'body.glb', bytes: body },
    { name: 'coat.glb', bytes: coat },
  ]);
  assert.equal(await rashWords(), 0, 'said before it was known');
  assert.match(await page.locator('.note').last().innerText(), /Clips chosen by the page: “walk”/);
  assert.equal(await page.getByLabel('arrangement').inputValue(), 'walking');
  const scene = await savedScene(page);
  assert.ok(scene.instances.every(({ velocity }) => Math.hypot(...velocity) > 0.1));
  const answer = check(t, scene, files);
  await agreesWith(answer);
  assert.equal(answer.counts[0], 0);
  assert.ok(answer.totals.contacts > 0);
  assert.equal(await number(page, 'listed'), answer.totals.contacts, 'of the whole clip');
  assert.equal(await page.locator('.same code').innerText(), 'pelt check scene.json');
});

test('two in one place are as the command has them, by the words that the page tells', async (t) => {
  await page.getByLabel('arrangement').selectOption('together');
  await counted(page);
  const words = ['body.glb', 'coat.glb', '--clip', 'walk', '--clip', 'walk'];
  const answer = checkFiles(t, files, words);
  assert.equal(await page.locator('.same code').innerText(), `pelt check ${words.join(' ')}`);
  await page.keyboard.press('ArrowRight');
  await agreesWith(answer);
  assert.equal((await savedScene(page)).frames.count, answer.counts.length);
  assert.ok(answer.totals.contacts > 1000, 'a scene worth testing');
});

describe('what plays, and where', () => {
  const card = () => page.locator('.card').first();
  const field = (label) => card().getByLabel(label, { exact: true });

  /** Typed key by key, as people do. */
  async function type(label, text) {
    await field(label).focus();
    await page.keyboard.press('Control+A');
    await field(label).pressSequentially(text, { delay: 30 });
    assert.equal(await field(label).inputValue(), text);
    await page.keyboard.press('Tab');
  }

  test('another clip makes the scene as long as it is', async (t) => {
    await page.keyboard.press('0');
    const before = (await savedScene(page)).frames.count;
    await card()
      .getByLabel('clip')
      .selectOption({ label: await idle() });
    const scene = await savedScene(page);
    assert.equal(scene.instances[0].clip, 'idle');
    assert.notEqual(scene.frames.count, before);
    const words = ['body.glb', 'coat.glb', '--clip', 'idle', '--clip', 'walk'];
    await agreesWith(checkFiles(t, files, words));
  });

  const idle = async () =>
    (await card().locator('option').allInnerTexts()).find((text) => text.startsWith('idle'));

  test('decimals can be typed while it stands', () => typesEverything(false));
  test('and while it plays', () => typesEverything(true));

  async function typesEverything(isPlaying) {
    if (isPlaying) await page.getByRole('button', { name: 'Play', exact: true }).click();
    await type('start s', isPlaying ? '0.35' : '0.05');
    await type('speed ×', isPlaying ? '-0.75' : '1.25');
    await type('x', isPlaying ? '-0.05' : '0.003');
    await type('turn °', isPlaying ? '-22.5' : '12.5');
    await type('z/s', isPlaying ? '-0.02' : '0.04');
    if (isPlaying) await page.getByRole('button', { name: 'Pause', exact: true }).click();
  }

  test('and are what the command finds', async (t) => {
    const scene = await savedScene(page);
    const [{ start, speed, translation, velocity, rotation }] = scene.instances;
    assert.deepEqual([start, speed, translation[0], velocity[2]], [0.35, -0.75, -0.05, -0.02]);
    assert.ok(Math.abs(rotation[1] - Math.sin((-22.5 * Math.PI) / 360)) < 1e-9);
    await agreesWith(check(t, scene, files));
  });

  test('the length and the frames per second can be chosen', async (t) => {
    const fieldOfScene = (label) => page.getByLabel(label, { exact: true });
    await fieldOfScene('fps').fill('60');
    const { frames } = await savedScene(page);
    assert.equal(frames.fps, 60);
    await fieldOfScene('frames').fill('12');
    await agreesWith(check(t, await savedScene(page), files));
    assert.equal(await page.locator('[aria-label=Frame]').getAttribute('max'), '11');
  });

  test('they walk into each other again', async (t) => {
    await page.getByLabel('arrangement').selectOption('walking');
    await agreesWith(check(t, await savedScene(page), files));
  });
});

describe('what touches', () => {
  test('is listed in full, and leads to its worst frame and its triangles', async () => {
    const rows = page.locator('.touch');
    await page.locator('.touches > li > .more').click();
    const sum = (await rows.locator('.count').allInnerTexts())
      .map(asNumber)
      .reduce((a, b) => a + b);
    assert.equal(sum, await number(page, 'total'));
    const title = (await rows.first().getAttribute('title')).replaceAll(',', '');
    const [, frame, contacts] = title.match(/(\d+) with (\d+)/);
    await goToFrame(page, 0);
    const far = await pixels(page);
    await rows.nth(1).focus();
    await page.keyboard.press('ArrowUp');
    await page.keyboard.press('Enter');
    await answered(page, frame);
    assert.equal(await number(page, 'frame'), Number(frame));
    const more = page.locator('.details .more');
    if (await more.count()) await more.click();
    const triangles = await page.locator('.triangles').innerText();
    assert.equal(triangles.match(/×/g).length, Number(contacts));
    await page.waitForTimeout(600); // until the camera has arrived
    assert.ok((await pixels(page)).count > far.count + 500, 'the camera is near the contacts');
    await page.keyboard.press('Escape');
    await page.locator('.triangles').waitFor({ state: 'detached' });
  });

  test('is shown by stills, which lead to their frames', async () => {
    const still = page.locator('.stills button').first();
    const { length } = await still.locator('img').getAttribute('src');
    assert.ok(length > 2000, 'a picture of something');
    const [, frame] = (await still.getAttribute('title')).match(/(\d+)/);
    await still.click();
    await answered(page, frame);
    assert.match(await still.innerText(), new RegExp(`^${await fact(page, 'contacts')} `));
  });

  const asNumber = (text) => Number(text.replaceAll(',', ''));
});

test('files of several parts, in several files and compressed are what the command reads', async (t) => {
  const gltf = inTwoFiles(inTwoParts(body), 'body');
  const packed = { name: 'coat.glb', bytes: await compressed(coat) };
  assert.ok(packed.bytes.length < coat.length);
  await drop([...gltf, packed]);
  const all = Object.fromEntries([...gltf, packed].map(({ name, bytes }) => [name, bytes]));
  await agreesWith(check(t, await savedScene(page), all));
  const touches = (await page.locator('.touches').innerText()).split('\n');
  assert.ok(touches.some((text) => text.includes('cloth')));
  assert.ok(touches.some((text) => text.includes('skin')));
});

test('weights that do not sum to 1 are divided by their sums on request', async (t) => {
  const light = withLightWeights(Buffer.from(body));
  await dropFiles(page, [{ name: 'light.glb', bytes: light }]);
  const problem = page.locator('.problem');
  assert.match(await problem.innerText(), /light\.glb[^]*sum to 0\.9, expected 1/);
  await problem.getByRole('button', { name: 'Read again, with weights divided' }).click();
  await page.waitForSelector('.subject:has-text("light.glb"):not(:has-text("reading"))');
  await counted(page);
  assert.equal(await problem.count(), 0);
  assert.match(await page.locator('.same code').innerText(), /--renormalise$/);
  const scene = await savedScene(page);
  await agreesWith(check(t, scene, { 'light.glb': light }, ['--renormalise']));
});

test('a scene finds the files that it names in folders', async (t) => {
  const models = { body: '../models/body.gltf', coat: 'coats/coat.glb' };
  const instances = [
    { model: 'body', clip: 'walk' },
    { model: 'coat', clip: 'idle' },
  ];
  const scene = { models, frames: { count: 4, fps: 30 }, instances };
  await drop([
    { name: 'scene.json', bytes: Buffer.from(JSON.stringify(scene)) },
    ...inTwoFiles(body, 'body'),
    { name: 'coat.glb', bytes: coat },
  ]);
  const flat = { ...scene, models: { body: 'body.glb', coat: 'coat.glb' } };
  await agreesWith(check(t, flat, files));
  assert.deepEqual((await savedScene(page)).models, models);
});

test('nothing went wrong', () => assert.deepEqual(page.complaints, []));
