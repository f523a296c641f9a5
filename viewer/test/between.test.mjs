// Contacts between frames: the switch, the marks, the list, and the first time of contact. All counts
// and times are those of `pelt check --between`.

import assert from 'node:assert/strict';
import { mkdirSync } from 'node:fs';
import path from 'node:path';
import { after, before, test } from 'node:test';
import * as browsing from './browser.mjs';
import { check } from './command.mjs';
import { poorContrasts, smallTargets } from './reading.mjs';
import { SCENE, STONES } from './reports.mjs';

const { answered, counted, dropFiles, fact, number, pixels, savedScene } = browsing;
const built = path.resolve(process.env.PELT_PAGE ?? 'dist/index.html');

/** Two heaps of stones, of which one flies through the other, and a walker that touches itself. */
const [STILL, OTHER] = SCENE.instances;
const FLYING = {
  ...SCENE,
  models: { cairn: 'cairn.gltf', walker: { creature: { triangles: 2000, joints: 45, seed: 5 } } },
  instances: [
    STILL,
    { ...OTHER, translation: [-0.5, 0.15, 0.05], velocity: [0.5, 0, 0] },
    { model: 'walker', clip: 'walk', translation: [3, 0, 0] },
  ],
  self_rings: 1,
  self_at_rest: 'keep',
  self_near_joints: 'keep',
};

let browser, page;
before(async () => {
  browser = await browsing.launch();
  page = await browsing.openPage(browser, browsing.urlOf(built), { reducedMotion: 'reduce' });
});
after(() => browser.close());

const between = () => page.getByRole('switch', { name: 'between frames' });
const steps = () => page.locator('.steps button');
const marks = () => page.locator('.steps-between rect');

/** The page has the contacts, steps and hash of the command. */
async function agrees(t, scene, options, files = {}) {
  const { totals } = check(t, scene, files, ['--between', ...options]);
  const { contacts, steps_in_contact: count, hash } = totals.between;
  await page.waitForSelector(`[data-fact=between-hash]:text-is("${hash}")`);
  assert.equal(await number(page, 'between'), contacts);
  assert.equal(await marks().count(), count);
  assert.equal(await steps().count(), Math.min(count, 8));
  return { contacts };
}

test('steps are tested once that is chosen, as the command tests them', async (t) => {
  assert.equal(await between().isChecked(), false);
  assert.equal(await marks().count(), 0);
  await page.keyboard.press('e');
  await page.waitForSelector('.steps-between');
  await counted(page);
  const { contacts } = await agrees(t, await savedScene(page), []);
  assert.ok(contacts > 10_000, `${contacts} contacts`);
  assert.match(await page.locator('.same').innerText(), /pelt check scene.json --between/);
  assert.match(await page.locator('.lead').innerText(), /in the steps between them\.$/);
  assert.deepEqual(await smallTargets(page), []);
  for (const colorScheme of ['light', 'dark']) {
    await page.emulateMedia({ colorScheme });
    await page.waitForTimeout(200); // until colours have changed
    assert.deepEqual(await poorContrasts(page), [], colorScheme);
  }
});

test('a step leads to its first time of contact, which is drawn', async () => {
  const [frame, to] = (await steps().first().innerText()).match(/\d+/g);
  await steps().first().click();
  await page.getByText(`to ${to}: first contact between them`).waitFor();
  await answered(page, Number(frame));
  assert.equal(await fact(page, 'contacts'), '1');
  assert.equal(await steps().first().getAttribute('aria-pressed'), 'true');
  await page.waitForTimeout(1000); // until the camera has turned
  const { count } = await pixels(page);
  assert.ok(count > 5 && count < 3000, `${count} pixels of two triangles glow`);
  if (process.env.PELT_PICTURES) {
    mkdirSync(process.env.PELT_PICTURES, { recursive: true });
    await page.screenshot({ path: path.join(process.env.PELT_PICTURES, 'between.png') });
  }
  await page.keyboard.press('ArrowRight');
  await answered(page, Number(to));
  assert.equal(await page.getByText('first contact between them').count(), 0);
  await page.keyboard.press('ArrowLeft');
  await answered(page, Number(frame));
  assert.match(await page.locator('.facts').innerText(), new RegExp(`more before frame ${to}`));
});

test('keys lead to steps that begin without contact', async () => {
  const begin = Number(await fact(page, 'frame'));
  await page.keyboard.press('Home');
  await answered(page, 0);
  await page.keyboard.press('n');
  await page.getByText('first contact between them').waitFor();
  const [, frame, to] = (await page.locator('.facts').innerText()).match(/frame (\d+) to (\d+)/);
  assert.ok(Number(frame) < begin);
  await answered(page, Number(frame));
  await page.keyboard.press('n');
  await answered(page, Number(to));
  assert.ok((await number(page, 'contacts')) > 0, 'the frame in which that step ends');
  await page.keyboard.press('p');
  await page.getByText(`frame ${frame} to ${to}: first contact`).waitFor();
});

test('steps are not tested with a limit, and vanish when they are switched off', async () => {
  await page.keyboard.press('f');
  await page.waitForSelector('.between', { state: 'detached' });
  assert.ok(await between().isDisabled());
  await page.keyboard.press('f');
  await page.waitForSelector('.between');
  await page.keyboard.press('e');
  await page.waitForSelector('.between', { state: 'detached' });
  assert.equal(await marks().count(), 0);
  await page.keyboard.press('e');
});

test('parts are tested in steps, and characters against themselves', async (t) => {
  await dropFiles(page, [
    { name: 'flying.json', bytes: Buffer.from(JSON.stringify(FLYING)) },
    { name: 'cairn.gltf', bytes: STONES },
  ]);
  await page.waitForSelector('.subject:has-text("flying.json")');
  const choose = (name) => page.locator('.self').getByRole('button', { name, exact: true }).click();
  const found = [];
  for (const [name, ...options] of [
    ['off', '--self=no'],
    ['also', '--self'],
    ['only', '--self=only'],
  ]) {
    await choose(name);
    found.push((await agrees(t, FLYING, options, { 'cairn.gltf': STONES })).contacts);
  }
  const [pairs, both, own] = found;
  assert.ok(pairs > 0 && own > 0 && both === pairs + own, `${found}`);
  await page.getByRole('switch', { name: 'parts' }).check();
  for (const [name, option] of [
    ['only', '--self=only'],
    ['also', '--self'],
  ]) {
    await choose(name);
    await agrees(t, FLYING, ['--by', 'part', option], { 'cairn.gltf': STONES });
  }
  assert.deepEqual(page.complaints, []);
});
