// Contacts of characters with themselves: the switch, the list, the filters, the colour. All counts
// are those of the command.

import assert from 'node:assert/strict';
import { mkdirSync, readFileSync } from 'node:fs';
import path from 'node:path';
import { after, before, test } from 'node:test';
import * as browsing from './browser.mjs';
import { check, checkFiles } from './command.mjs';
import { poorContrasts, smallTargets } from './reading.mjs';
import { SCENE, STONES } from './reports.mjs';

const { answered, counted, dropFiles, fact, goToFrame, number, pixels, savedScene } = browsing;
const built = path.resolve(process.env.PELT_PAGE ?? 'dist/index.html');

/** Two heaps of stones, which touch their own stones at rest, and one that walks. */
const STAGE = {
  ...SCENE,
  models: { ...SCENE.models, walker: { creature: { triangles: 2000, joints: 45, seed: 5 } } },
  instances: [...SCENE.instances, { model: 'walker', clip: 'walk', translation: [3, 0, 0] }],
};
const OPEN = { self_rings: 1, self_at_rest: 'keep', self_near_joints: 'keep' };
const FRAME = 5;

let browser, page;
before(async () => {
  browser = await browsing.launch();
  page = await browsing.openPage(browser, browsing.urlOf(built), { reducedMotion: 'reduce' });
});
after(() => browser.close());

const choose = (name) => page.locator('.self').getByRole('button', { name, exact: true }).click();
const ofClip = () => page.getByRole('button', { name: 'whole clip' }).click();

/** The models of the scene are in one folder. */
const withoutFolder = (scene) => ({
  ...scene,
  models: { ...scene.models, cairn: 'cairn.gltf' },
});

async function drop(scene, name) {
  const bytes = Buffer.from(JSON.stringify(withoutFolder(scene)));
  await dropFiles(page, [
    { name, bytes },
    { name: 'cairn.gltf', bytes: STONES },
  ]);
  await page.waitForSelector(`.subject:has-text("${name}")`);
  await counted(page);
}

/** The command's answer, which the page must give. */
async function agrees(t, scene, options = []) {
  const answer = check(t, withoutFolder(scene), { 'cairn.gltf': STONES }, options);
  await page.waitForSelector(`[data-fact=hash]:text-is("${answer.hash}")`);
  assert.equal(await number(page, 'total'), answer.totals.contacts);
  await goToFrame(page, FRAME);
  assert.equal(await number(page, 'contacts'), answer.counts[FRAME]);
  await ofClip();
  return answer;
}

const listed = (kind) => number(page, `listed-${kind}`);

/** The numbers that the page shows beside the filters are those of the command. */
async function droppedAs({ totals: { left_out: leftOut } }) {
  const shown = {};
  for (const name of ['rings', 'rest', 'always', 'joints']) {
    shown[name] = await number(page, `dropped-${name}`);
  }
  assert.deepEqual(shown, {
    rings: leftOut.rings,
    rest: leftOut.at_rest,
    always: leftOut.always,
    joints: leftOut.near_joints,
  });
  return leftOut;
}

test('several characters are not tested against themselves, until that is chosen', async (t) => {
  await drop(STAGE, 'stage.json');
  await agrees(t, STAGE);
  assert.equal(await page.locator('.self-list').count(), 0);
  await page.keyboard.press('x');
  const also = await agrees(t, STAGE, ['--self']);
  await page.getByRole('button', { name: 'Filters' }).click();
  const { at_rest: atRest, rings } = await droppedAs(also);
  assert.ok(atRest > 0 && rings > 0, 'filters worth testing');
  assert.match(await page.locator('.same').innerText(), /--self\b/);
  await choose('only');
  await agrees(t, STAGE, ['--self=only']);
  await choose('off');
  await agrees(t, STAGE);
});

test('a scene chooses, and is saved with its choices', async (t) => {
  const scene = { ...STAGE, self: true, ...OPEN };
  await drop(scene, 'open.json');
  const { totals } = await agrees(t, scene);
  await droppedAs({ totals });
  const [own, others] = [await listed('self'), await listed('pairs')];
  assert.ok(own > 0 && others > 0, 'a scene worth testing');
  assert.equal(own + others, totals.contacts);
  const { models: _, ...saved } = await savedScene(page);
  assert.equal(saved.self, true);
  for (const [key, value] of Object.entries(OPEN)) assert.equal(saved[key], value);

  const row = page.locator('.self-list .touch').first();
  const count = Number(await row.locator('.count').innerText());
  await row.click();
  await page.waitForSelector('.self-list .triangles');
  assert.ok(count > 0);
  await page.keyboard.press('Escape');
});

test('each filter has the name and the effect that it has in the command', async (t) => {
  const scene = { ...STAGE, self: true, ...OPEN };
  const field = (name) => page.locator('.self-filters').getByLabel(name, { exact: true });
  await field('near joints').selectOption('drop');
  let answer = await agrees(t, { ...scene, self_near_joints: 'drop' });
  assert.ok((await droppedAs(answer)).near_joints > 0);
  await field('near joints').selectOption('keep');
  await field('rings').fill('3');
  answer = await agrees(t, { ...scene, self_rings: 3 });
  await droppedAs(answer);
  await field('rings').fill('1');
  await field('always').selectOption('drop');
  await field('share of frames').fill('0.5');
  answer = await agrees(t, { ...scene, self_always: 0.5 });
  assert.ok((await droppedAs(answer)).always > 0);
  await field('always').selectOption('keep');
  await agrees(t, scene);
});

test('they are those of --by part and of --first, too', async (t) => {
  const scene = { ...STAGE, self: true, ...OPEN };
  await page.getByLabel('parts').check();
  await agrees(t, scene, ['--by', 'part']);
  const field = (name) => page.locator('.self-filters').getByLabel(name, { exact: true });
  await field('at rest').selectOption('drop');
  const closed = { ...scene, self_at_rest: 'drop' };
  const ofParts = await droppedAs(await agrees(t, closed, ['--by', 'part']));
  assert.ok(ofParts.at_rest > 0, 'parts that touch at rest');
  await field('near joints').selectOption('drop');
  const usual = { ...closed, self_near_joints: 'drop' };
  await droppedAs(await agrees(t, usual, ['--by', 'part']));
  await page.keyboard.press('f');
  const first = check(t, withoutFolder(usual), { 'cairn.gltf': STONES }, [
    '--by',
    'part',
    '--first',
  ]);
  await page.waitForSelector(`[data-fact=total]:text-is("${first.totals.contacts}")`);
  await droppedAs(first);
  await page.keyboard.press('f');
  await field('near joints').selectOption('keep');
  await field('at rest').selectOption('keep');
  await choose('only');
  await agrees(t, { ...scene, self: 'only' }, ['--by', 'part']);
  assert.equal(await page.locator('.pairs-list').count(), 0);
  await choose('also');
  await page.getByLabel('parts').uncheck();
  await page.keyboard.press('f');
  for (const [limit, words] of [
    [1, ['--first']],
    [3, ['--max-contacts', '3']],
  ]) {
    await page.getByLabel('per pair').fill(String(limit));
    const { totals } = check(t, withoutFolder(scene), { 'cairn.gltf': STONES }, words);
    await page.waitForSelector(`[data-fact=total]:text-is("${totals.contacts}")`);
    await droppedAs({ totals });
    const contacts = `at most ${limit} contacts?`;
    const sentence = `^Orange marks ${contacts} of each pair of characters; violet marks ${contacts} of each`;
    assert.match(await page.locator('.lead').innerText(), new RegExp(sentence));
  }
  await page.getByRole('switch', { name: 'limit' }).uncheck();
  assert.equal(await page.getByLabel('per pair').count(), 0);
});

test('they have a colour of their own, in picture and timeline', async () => {
  await goToFrame(page, FRAME);
  await choose('only');
  await answered(page, FRAME);
  await page.waitForTimeout(300);
  assert.ok((await pixels(page, browsing.VIOLET)).count > 50);
  assert.ok((await pixels(page)).count < 5, 'nothing else glows');
  const bars = (style) => page.locator(`.chart path${style}`).getAttribute('d');
  assert.equal(await bars('.of-self'), await bars(':not(.of-self)'));
  await choose('also');
  await answered(page, FRAME);
  await page.waitForTimeout(300);
  assert.ok((await pixels(page)).count > 20);
  assert.match(await page.locator('.lead').innerText(), /^Orange marks [^;]*; violet marks/);
  for (const colorScheme of ['light', 'dark']) {
    await page.emulateMedia({ colorScheme });
    await page.waitForTimeout(200); // until colours have changed
    assert.deepEqual(await poorContrasts(page), [], colorScheme);
  }
  assert.deepEqual(await smallTargets(page), []);
});

test('a character that is alone is tested against itself', async (t) => {
  const folder = process.env.PELT_MODELS;
  const bytes = readFileSync(path.join(folder, 'coat.glb'));
  await dropFiles(page, [{ name: 'coat.glb', bytes }]);
  await page.waitForSelector('.card:has-text("coat.glb")');
  await counted(page);
  assert.match(await page.locator('.lead').innerText(), /^Violet marks/);
  const alone = checkFiles(t, { 'coat.glb': bytes }, ['coat.glb', '--clip', 'walk']);
  assert.equal(await fact(page, 'hash'), alone.hash);
  assert.equal(await page.locator('.same code').innerText(), 'pelt check coat.glb --clip walk');
  const field = (name) => page.locator('.self-filters').getByLabel(name, { exact: true });
  await field('rings').fill('1');
  await field('near joints').selectOption('keep');
  const words = ['--clip', 'walk', '--self-rings', '1', '--self-near-joints', 'keep'];
  const open = checkFiles(t, { 'coat.glb': bytes }, ['coat.glb', ...words]);
  assert.ok(open.totals.contacts > 0, 'a character worth testing');
  await page.waitForSelector(`[data-fact=hash]:text-is("${open.hash}")`);
  assert.equal(
    await page.locator('.same code').innerText(),
    ['pelt check coat.glb', ...words].join(' '),
  );
  if (process.env.PELT_PICTURES) await picture('self');
  await choose('off');
  await page.waitForSelector('[data-fact=total]:text-is("0")');
  assert.deepEqual(page.complaints, []);
});

async function picture(name) {
  mkdirSync(process.env.PELT_PICTURES, { recursive: true });
  await page.setViewportSize({ width: 1280, height: 800 });
  await page.waitForTimeout(1000);
  await page.screenshot({ path: path.join(process.env.PELT_PICTURES, `${name}.png`) });
}
