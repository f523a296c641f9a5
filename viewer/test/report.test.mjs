// What a report says about the check, and whether the page finds the same: parts, ignored pairs,
// baselines, ranges of frames.

import assert from 'node:assert/strict';
import { existsSync, mkdirSync, readFileSync, statSync } from 'node:fs';
import path from 'node:path';
import { after, before, test } from 'node:test';
import * as browsing from './browser.mjs';
import { poorContrasts, smallTargets } from './reading.mjs';
import { SCENE, STONES, Workshop } from './reports.mjs';

const { counted, dropFiles, fact, goToFrame, number, pixels, savedScene } = browsing;
const TEN_MEGABYTES = 10e6;
/** The colour of segments between closest points. */
const SEGMENTS = { least: [0, 190, 170], most: [120, 255, 240] };
const IGNORE = [
  ['base', 'm*'],
  ['cairn/top', 'top'],
];

let browser;
before(async () => (browser = await browsing.launch()));
after(() => browser.close());

/** Opens a page for the duration of a test, without motion: playing pages slow each other down. */
async function open(t, url, motion = 'reduce') {
  const page = await browsing.openPage(browser, url, { reducedMotion: motion });
  t.after(() => page.context().close());
  return page;
}

/** The same without a picture: for tests that count and read. */
async function openToCount(t, url) {
  const page = await browsing.openToCount(browser, url);
  t.after(() => page.context().close());
  return page;
}

const report = (page) => page.locator('section:has(#report)');
const says = (page, text) => report(page).filter({ hasText: text }).waitFor();

async function agreesWith(page, { totals, hash }) {
  await says(page, 'the page agrees');
  assert.equal(await number(page, 'total'), totals.contacts);
  assert.equal(await fact(page, 'hash'), hash);
  if (totals.ignored > 0) assert.equal(await number(page, 'ignored'), totals.ignored);
}

test('a report of parts shows what is ignored, and what is worse than in a baseline', async (t) => {
  const shop = new Workshop(t);
  shop.run('check', 'scene.json', '--by', 'part', '--frames', '0:1', '--jsonl', 'known.jsonl');
  const ignore = IGNORE.flatMap((pair) => ['--ignore', pair.join(',')]);
  const answer = shop.check('--by', 'part', ...ignore, '--baseline', 'known.jsonl');
  const { worse } = answer.verdict;
  const fresh = worse.filter(({ known }) => known === 0).length;
  assert.ok(
    answer.totals.ignored > 0 && fresh > 0 && worse.length > fresh,
    'a check worth testing',
  );

  const page = await openToCount(t, browsing.urlOf(shop.at('report.html')));
  await agreesWith(page, answer);
  await says(page, 'Check failed');
  await says(page, `${fresh} new, ${worse.length - fresh} grown`);
  await says(page, /models\/cairn\.gltf\s*[\d,]+ bytes/);
  assert.equal(await page.locator('.touches .standing.new').count(), fresh);
  assert.equal(await page.locator('.touches .standing.grown').count(), worse.length - fresh);
  const ofRows = await page.locator('.touches .worse').allInnerTexts();
  assert.ok(
    ofRows.slice(0, fresh).every((text) => text.startsWith('new')),
    'the new ones on top',
  );
  const [{ worst, known }] = worse.filter((touch) => touch.known > 0);
  assert.equal(ofRows[fresh], `grown ${worst.contacts} in frame ${worst.frame}, was ${known}`);
  await filters(page, answer);
  await page.locator('.card .title').first().click();
  for (const colorScheme of ['light', 'dark']) {
    await page.emulateMedia({ colorScheme });
    await page.waitForTimeout(200); // until colours have changed
    assert.deepEqual(await poorContrasts(page), [], colorScheme);
  }
  assert.deepEqual(await smallTargets(page), []);
  assert.equal(await alignedSwitches(page), 1, 'the switches stand in one line');
  const { ignore: saved, models } = await savedScene(page);
  assert.deepEqual(saved, IGNORE);
  assert.deepEqual(models, { cairn: 'models/cairn.gltf' });
  assert.deepEqual(page.complaints, []);
});

/** The list can be restricted to what is new, grown, known or gone, and searched. */
async function filters(page, { verdict: { worse, gone }, touches }) {
  const rows = page.locator('.touches .touch');
  const choose = (name) => page.getByRole('button', { name: new RegExp(`^\\d+ ${name}$`) }).click();
  await choose('grown');
  assert.equal(await rows.count(), worse.filter(({ known }) => known > 0).length);
  await choose('known');
  assert.equal(await rows.count(), touches.length - worse.length);
  await choose('gone');
  assert.equal(await page.locator('.gone li').count(), gone.length);
  assert.ok(gone.length > 0, 'a baseline worth testing');
  await choose('gone');
  const search = page.getByRole('searchbox', { name: 'Search contacts' });
  await search.fill('top 1');
  const places = ({ a, b }) =>
    [a, b].map(({ instance, part, joint }) => `${instance}${part}${joint}`);
  const wanted = touches
    .map((touch) => places(touch).join())
    .filter((text) => {
      return text.includes('top') && text.includes('1');
    });
  assert.ok(wanted.length > 0 && wanted.length < touches.length, 'a search worth testing');
  assert.equal(await rows.count(), wanted.length);
  await search.fill('no such joint');
  await page.locator('.nothing').filter({ hasText: 'No contact matches' }).waitFor();
  await search.fill('');
  await says(page, 'compared with known.jsonl');
}

/** Number of lines that the switches of the query take. */
async function alignedSwitches(page) {
  const boxes = await Promise.all(
    (await page.locator('.switches .switch').all()).map((one) => one.boundingBox()),
  );
  assert.equal(boxes.length, 3);
  return new Set(boxes.map(({ y }) => y)).size;
}

test('a report of steps lists and marks those with contacts between frames', async (t) => {
  const [still, other] = SCENE.instances;
  const flying = { ...other, translation: [-0.5, 0.15, 0.05], velocity: [0.5, 0, 0] };
  const shop = new Workshop(t, { ...SCENE, instances: [still, flying] });
  const answer = shop.check('--between');
  const { contacts, steps_in_contact: steps } = answer.totals.between;
  assert.ok(steps > 0, 'steps worth testing');
  const page = await openToCount(t, browsing.urlOf(shop.at('report.html')));
  await agreesWith(page, answer);
  await says(page, new RegExp(`${contacts.toLocaleString('en')} contacts? between frames only`));
  assert.equal(await page.locator('.steps button').count(), Math.min(steps, 8));
  assert.equal(await page.locator('.steps-between rect').count(), steps);
  await page.locator('.steps button').first().click();
  const [frame, to] = (await page.locator('.steps button').first().innerText()).match(/\d+/g);
  await page.waitForSelector(`[data-fact=frame]:text-is("${frame}")`);
  await page.getByText(`to ${to}: first contact between them`).waitFor();
  await page.waitForSelector(`[data-answered="${frame}"]`);
  assert.equal(await page.locator('[data-fact=contacts]').innerText(), '1');
  await page.keyboard.press('ArrowRight');
  await page.waitForSelector(`[data-fact=frame]:text-is("${to}")`);
  await page.keyboard.press('ArrowLeft');
  await page.waitForSelector(`[data-fact=frame]:text-is("${frame}")`);
  assert.equal(await page.getByText('first contact between them').count(), 0);
  await page.waitForSelector(`[data-answered="${frame}"]`); // facts are pale until then
  await page.waitForFunction(() => document.getAnimations().length === 0);
  assert.deepEqual(await smallTargets(page), []);
  assert.deepEqual(await poorContrasts(page), []);
  assert.deepEqual(page.complaints, []);
});

/** A walker goes through another one. */
const WALKERS = {
  models: {
    red: { creature: { triangles: 2000, joints: 45, seed: 5 } },
    blue: { creature: { triangles: 1664, joints: 45, seed: 3 } },
  },
  frames: { count: 24, fps: 12 },
  instances: [
    { model: 'red', clip: 'walk' },
    { model: 'blue', clip: 'walk', translation: [-2, 0, 0.2], velocity: [2, 0, 0] },
  ],
};

test('a report with a budget shows what is unknown, until all contacts are wanted', async (t) => {
  const shop = new Workshop(t, WALKERS);
  const answer = shop.check('--budget', '1000');
  const { frames, frames_in_contact: touching, contacts, unknown } = answer.totals;
  assert.equal(answer.hash, null);
  assert.ok(touching > 0 && unknown.frames > touching, 'a budget worth testing');
  const page = await openToCount(t, browsing.urlOf(shop.at('report.html')));
  await says(page, 'the page agrees');
  await says(page, `Contact in ${touching} of ${frames} frames, ${unknown.frames} not decided`);
  assert.equal(await number(page, 'total'), contacts);
  assert.equal(await page.locator('[data-fact=hash]').count(), 0);
  assert.equal(await number(page, 'unknown'), unknown.frames - touching);
  assert.equal(await number(page, 'touching'), touching);
  assert.equal(await number(page, 'decided'), frames - unknown.frames);
  assert.ok((await page.locator('.undecided rect').count()) > 0);
  assert.equal(await page.locator('.self').count(), 0, 'there is no such self-test');
  assert.ok(await page.getByRole('switch', { name: 'limit' }).isDisabled());
  await page.getByRole('button', { name: 'this frame' }).click();
  await goToFrame(page, 8);
  assert.match(await page.locator('.facts').innerText(), /[\d,]+ pairs of triangles not decided/);
  await page.getByText('No contact is known.').waitFor();
  if (process.env.PELT_PICTURES) await picture(page, 'budget');
  for (const check of [smallTargets, poorContrasts]) assert.deepEqual(await check(page), []);
  for (const key of ['b', '[', '[']) await page.keyboard.press(key);
  await page.waitForFunction(() => {
    return /[1-9]\d* opened/.test(document.querySelector('.legend')?.innerText);
  });
  await page.getByRole('button', { name: 'Find all contacts' }).click();
  const { totals, hash } = shop.check();
  await page.waitForSelector(`[data-fact=hash]:text-is("${hash}")`);
  assert.equal(await number(page, 'total'), totals.contacts);
  await says(page, 'the page agrees; changed since');
  assert.equal(await page.locator('.undecided, .budget').count(), 0);
  assert.deepEqual(page.complaints, []);
});

test('a budget that suffices leaves nothing unknown', async (t) => {
  const shop = new Workshop(t);
  const answer = shop.check('--budget', '1000000', '--by', 'part');
  const page = await openToCount(t, browsing.urlOf(shop.at('report.html')));
  await agreesWith(page, answer);
  assert.equal(await number(page, 'decided'), answer.totals.frames);
  assert.equal(await page.locator('.undecided').count(), 0);
});

test('a report of some frames counts and marks just these', async (t) => {
  const shop = new Workshop(t);
  const words = ['--frames', '2:12:3'];
  const answer = shop.check(...words);
  const page = await open(t, browsing.urlOf(shop.at('report.html')));
  await says(page, 'the page agrees');
  await says(page, answer.hash);
  await says(page, `Contact in ${answer.totals.frames_in_contact} of 4 frames`);
  const sections = await page.locator('.side section').evaluateAll((all) => {
    return all.map((section) => section.getAttribute('aria-labelledby'));
  });
  assert.deepEqual(sections, ['report', 'contacts', 'characters', 'work']);
  assert.equal(await number(page, 'total'), answer.totals.contacts);
  assert.equal(await fact(page, 'hash'), answer.hash);
  assert.match(await page.locator('.facts').innerText(), /\d of 4 checked frames/);
  const stills = await page
    .locator('.stills button')
    .evaluateAll((all) => all.map((one) => one.title));
  assert.ok(
    stills.length > 0 && stills.every((title) => /frame (2|5|8|11)$/.test(title)),
    `${stills}`,
  );
  assert.equal(await page.locator('.unchecked rect').count(), 4, 'before, and between the frames');
  await goToFrame(page, 3);
  assert.match(await page.locator('.facts').innerText(), /not checked/);
  await page.locator('.card .title').first().click();
  await page.getByLabel('x', { exact: true }).fill('0.2');
  await says(page, 'the page agrees; changed since');
  assert.match(await page.locator('.same').innerText(), /pelt check scene.json --frames 2:12:3/);
  const { contacts } = answer.totals;
  await page.getByRole('button', { name: 'Undo' }).click();
  await says(page, /the page agrees(?!;)/);
  await page.getByRole('button', { name: 'Check all frames' }).click();
  const { totals, hash } = shop.check();
  await page.waitForSelector(`[data-fact=hash]:text-is("${hash}")`);
  assert.equal(await number(page, 'total'), totals.contacts);
  assert.ok(totals.contacts > contacts, 'a range worth testing');
  assert.equal(await page.locator('.unchecked').count(), 0);
});

test('a report plays, glows, tells the work and takes other files', async (t) => {
  const shop = new Workshop(t, { ...SCENE, frames: { count: 90, fps: 60 } });
  const answer = shop.check();
  const page = await open(t, browsing.urlOf(shop.at('report.html')), 'no-preference');
  await agreesWith(page, answer);
  assert.match(await report(page).innerText(), /pelt check scene\.json [^]*--html report\.html/);
  assert.equal(await page.title(), 'scene.json · Pelt');
  const first = await number(page, 'frame');
  await says(page, `most in frame ${first}: ${await fact(page, 'contacts')}`);
  await page.getByRole('button', { name: 'Play', exact: true }).click();
  await page.waitForFunction((frame) => {
    return Number(document.querySelector('[data-fact=frame]').textContent) !== frame;
  }, first);
  await goToFrame(page, 45);
  const contacts = await pixels(page);
  assert.ok(contacts.count > 100);
  await selectsWithoutHandles(page, contacts);
  for (const still of await page.locator('.stills img').all()) {
    assert.ok((await pixels(page, browsing.GLOWING, still)).count > 20, 'a still of contacts');
  }
  assert.ok((await page.locator('.stills img').count()) > 0);
  if (process.env.PELT_PICTURES) await picture(page, 'report');
  await dropFiles(page, [{ name: 'stones.gltf', bytes: STONES }]);
  await page.waitForSelector('.card:has-text("stones.gltf")');
  assert.deepEqual(
    page.fetched.filter((url) => !/^(file|data|blob):/.test(url)),
    [],
  );
  assert.deepEqual(page.complaints, []);
});

/** A click on a body shows its card, and moves nothing: handles come on demand. */
async function selectsWithoutHandles(page, { x, y }) {
  const handles = async () => (await pixels(page, browsing.RED_HANDLE)).count;
  await page.mouse.click(x, y);
  const { y: top, height } = await page.locator('.card.selected').boundingBox();
  const panel = await page.locator('.side').boundingBox();
  assert.ok(
    top >= panel.y && top + height <= panel.y + panel.height,
    `card ${top} + ${height} in ${panel.y} + ${panel.height}`,
  );
  assert.equal(await handles(), 0);
  await page.keyboard.press('g');
  await page.waitForTimeout(300);
  assert.ok((await handles()) > 0);
  await page.keyboard.press('Escape');
}

async function picture(page, name) {
  mkdirSync(process.env.PELT_PICTURES, { recursive: true });
  await page.setViewportSize({ width: 1280, height: 760 });
  await page.waitForTimeout(1000);
  await page.screenshot({ path: path.join(process.env.PELT_PICTURES, `${name}.png`) });
}

test('a report of models and one frame has their names, and nothing to play', async (t) => {
  const shop = new Workshop(t);
  const model = 'models/cairn.gltf';
  shop.run('check', model, model, '--at', '0.1,0.15,0.05', '--html', 'report.html');
  const page = await openToCount(t, browsing.urlOf(shop.at('report.html')));
  await says(page, 'Contact in frame 0');
  assert.equal(await page.title(), 'cairn.gltf · Pelt');
  assert.ok(await page.getByRole('button', { name: 'Play', exact: true }).isDisabled());
  assert.match(await page.locator('.facts').innerText(), /frame 0, the only one[^]*in 1 frame\b/);
});

test('a report tells which of many instances touch', async (t) => {
  const far = SCENE.instances.map(({ translation: [x, ...rest] = [0, 0, 0], ...instance }) => {
    return { ...instance, translation: [x + 9, ...rest] };
  });
  const alone = { model: 'cairn', clip: 'roll', translation: [0, 0, 9] };
  const shop = new Workshop(t, { ...SCENE, instances: [...SCENE.instances, ...far, alone] });
  const { contacts } = shop.check().totals;
  const page = await openToCount(t, browsing.urlOf(shop.at('report.html')));
  const rows = await page.locator('.pairs li').allInnerTexts();
  assert.equal(rows.length, 2);
  const counts = rows.map((row) => Number(row.split(/\s+/).at(-1)));
  assert.equal(counts[0] + counts[1], contacts);
  assert.ok(rows.some((row) => /^0\s*cairn\s+1\s*cairn\s/.test(row)));
  const touching = page.locator('.touches .touch');
  const all = await touching.count();
  await page.getByRole('button', { name: /^2\s*cairn\s*3/ }).click();
  assert.ok((await touching.count()) < all);
  assert.match(await touching.first().innerText(), /^2/);
  await page.getByRole('button', { name: /^only 2 and 3/ }).click();
  assert.equal(await touching.count(), all);
  assert.equal(await page.locator('.card').count(), 0, 'many cards are folded');
  await page.getByRole('button', { name: '5 characters' }).click();
  assert.equal(await page.locator('.card').count(), 5);
  const areas = await page
    .locator('.side, .side *')
    .evaluateAll((all) =>
      all
        .filter((one) => /auto|scroll/.test(getComputedStyle(one).overflowY))
        .map((one) => one.className),
    );
  assert.deepEqual(areas, ['side'], 'the panel scrolls as a whole');
});

test('a report tells which bodies are inside others', async (t) => {
  const small = { model: 'cairn', scale: 0.1, translation: [0.1, 0.1, 0.1] };
  const shop = new Workshop(t, { ...SCENE, instances: [{ model: 'cairn' }, small] });
  const { held } = shop.check('--inside');
  assert.equal(held.length, 1);
  const page = await openToCount(t, browsing.urlOf(shop.at('report.html')));
  await says(page, '1 cairn is wholly inside 0 cairn in 12 frames, first in frame 0');
  await page.locator('.nothing').filter({ hasText: 'Nothing touches in any frame.' }).waitFor();
  assert.ok(await page.getByRole('button', { name: 'Next contact' }).isDisabled());
});

test('a report of characters that touch themselves agrees, whatever the options', async (t) => {
  const walker = { creature: { triangles: 2000, joints: 45, seed: 5 } };
  const instances = [...SCENE.instances, { model: 'walker', clip: 'walk', translation: [3, 0, 0] }];
  const models = { ...SCENE.models, walker };
  const shop = new Workshop(t, { ...SCENE, models, instances, self: true, self_rings: 1 });
  const opened = ['--self-near-joints', 'keep', '--self-at-rest', 'keep'];
  const runs = [
    [],
    ['--self=only', ...opened],
    [...opened, '--self-always', '0.5', '--frames', '2:12:3'],
  ];
  for (const words of runs) {
    const answer = shop.check(...words);
    assert.ok(Object.values(answer.totals.left_out).some((count) => count > 0));
    const page = await openToCount(t, browsing.urlOf(shop.at('report.html')));
    await agreesWith(page, answer);
    assert.match(await page.locator('.lead').innerText(), /iolet marks every triangle/);
    const own = answer.touches.filter(({ a, b }) => a.instance === b.instance);
    const count = own.reduce((sum, { contacts }) => sum + contacts, 0);
    if (count > 0) assert.equal(await number(page, 'listed-self'), count);
    await page.getByText('Inputs and options').click();
    await says(page, /self-rings\s*1/);
    await page.keyboard.press('x');
    await says(page, 'the page agrees; changed since');
    await page.context().close();
  }
});

test('a report agrees whichever way joints are blended', async (t) => {
  const creature = (seed) => ({ creature: { triangles: 2000, joints: 45, seed } });
  const dual = { skinning: 'dual-quaternion' };
  const models = {
    cairn: { file: 'models/cairn.gltf', ...dual },
    one: { ...creature(5), ...dual },
    two: creature(6),
  };
  const instances = [
    { model: 'one', clip: 'walk' },
    { model: 'two', clip: 'walk', start: 0.4, translation: [0.2, 0, 0.1], rotation: [0, 1, 0, 0] },
    { model: 'cairn', clip: 'roll', translation: [0.1, 0.9, 0.05] },
  ];
  const shop = new Workshop(t, { models, frames: { count: 6, fps: 6 }, instances });
  const hashes = new Set();
  for (const words of [[], ['--skinning', 'dual-quaternion'], ['--skinning', 'linear']]) {
    const answer = shop.check(...words);
    hashes.add(answer.hash);
    const page = await openToCount(t, browsing.urlOf(shop.at('report.html')));
    await agreesWith(page, answer);
    await page.getByText('Inputs and options').click();
    if (words.length > 0) await says(page, new RegExp(`skinning\\s*${words[1]}`));
    assert.deepEqual((await savedScene(page)).models, models);
    await page.context().close();
  }
  assert.equal(hashes.size, 3);
});

test('a report of limited contacts agrees, and another limit can be chosen', async (t) => {
  const walker = { creature: { triangles: 2000, joints: 45, seed: 5 } };
  const instances = [...SCENE.instances, { model: 'walker', clip: 'walk', translation: [3, 0, 0] }];
  const models = { ...SCENE.models, walker };
  const shop = new Workshop(t, { ...SCENE, models, instances });
  const opened = ['--self', '--self-rings', '1', '--self-near-joints', 'keep'];
  const runs = [
    [['--first'], []],
    [['--first'], [...opened, '--by', 'part']],
    [
      ['--max-contacts', '3'],
      ['--self=only', ...opened.slice(1), '--by', 'part'],
    ],
    [['--max-contacts', '2'], opened],
  ];
  let page;
  for (const [limit, words] of runs) {
    const all = shop.check(...words);
    const answer = shop.check(...limit, ...words);
    assert.ok(answer.totals.contacts < all.totals.contacts, 'a limit worth testing');
    await page?.context().close();
    page = await openToCount(t, browsing.urlOf(shop.at('report.html')));
    await says(page, 'the page agrees');
    assert.equal(await number(page, 'total'), answer.totals.contacts);
    assert.equal(await page.locator('[data-fact=hash]').count(), 0);
  }
  await page.getByText('Inputs and options').click();
  await says(page, /max-contacts\s*2 per pair and frame/);
  assert.match(await page.locator('.lead').innerText(), /at most 2 contacts of each pair of char/);
  await page.getByLabel('per pair').fill('4');
  await says(page, 'the page agrees; changed since');
  await totalIs(page, shop.check('--max-contacts', '4', ...opened));
  assert.match(await page.locator('.same').innerText(), /--max-contacts 4 --self/);
  await page.getByRole('switch', { name: 'limit' }).uncheck();
  await totalIs(page, shop.check(...opened));
  assert.deepEqual(page.complaints, []);
});

test('a report of distances shows the triangles that the command counts', async (t) => {
  const clearance = ['--clearance', '0.03'];
  const shop = new Workshop(t, { ...SCENE, ignore: IGNORE });
  const runs = [
    [IGNORE, []],
    [IGNORE, ['--by', 'part', '--frames', '2:12:3']],
    [[], ['--max-contacts', '3', '--by', 'part']],
  ];
  let page;
  for (const [ignore, words] of runs) {
    shop.write({ ...SCENE, ignore });
    const touching = shop.check(...words);
    const answer = shop.check(...clearance, ...words);
    assert.ok(answer.totals.contacts > touching.totals.contacts, 'a distance worth testing');
    assert.equal(answer.totals.ignored > 0, ignore.length > 0);
    await page?.context().close();
    page = await openToCount(t, browsing.urlOf(shop.at('report.html')));
    await says(page, 'the page agrees');
    await totalIs(page, answer);
    if (answer.hash) assert.equal(await fact(page, 'hash'), answer.hash);
    if (answer.totals.ignored > 0)
      assert.equal(await number(page, 'ignored'), answer.totals.ignored);
    assert.equal(await page.locator('.self').count(), 0, 'there is no such self-test');
  }
  assert.match(await page.locator('.lead').innerText(), /3 pairs of triangles at most 0.03 apart/);
  await page.getByRole('switch', { name: 'limit' }).uncheck();
  await says(page, 'the page agrees; changed since');
  await totalIs(page, shop.check(...clearance, '--by', 'part'));
  assert.match(await page.locator('.same').innerText(), /--by part --clearance 0.03/);
  await page.keyboard.press('b');
  await page.waitForFunction(() => {
    return /[1-9]\d* opened/.test(document.querySelector('.legend')?.innerText);
  });
  await dropFiles(page, [{ name: 'stones.gltf', bytes: STONES }]);
  await page.waitForSelector('.card:has-text("stones.gltf")');
  assert.match(await page.locator('.lead').innerText(), /that intersects/);
  assert.deepEqual(page.complaints, []);
});

test('a report of distances draws the closest points, and counts the work of the command', async (t) => {
  const apart = structuredClone(SCENE);
  apart.instances[1].translation = [0, 2, 0];
  for (const by of ['instance', 'part']) {
    const shop = new Workshop(t, apart);
    const words = ['--by', by, '--frames', '4:5'];
    shop.run('distance', 'scene.json', ...words, '--within', '1.2', '--jsonl', 'distances.jsonl');
    const [, line] = readFileSync(shop.at('distances.jsonl'), 'utf8').split('\n');
    const pairs = JSON.parse(line).pairs.filter(({ distance }) => distance > 0);
    assert.ok(pairs.length > 0, 'distances worth testing');
    const { counters } = shop.check('--clearance', '1.2', ...words);
    const page = await open(t, browsing.urlOf(shop.at('report.html')));
    await says(page, 'the page agrees');
    const more = page.locator('.closest .more');
    if (await more.count()) await more.click();
    const rows = await page.locator('.closest .count').allInnerTexts();
    const least = pairs.map(({ distance }) => distance).sort((a, b) => a - b);
    assert.deepEqual(
      rows.filter((row) => row !== 'touch'),
      least.map((distance) => distance.toFixed(6)),
    );
    await page.getByRole('button', { name: 'Work' }).click();
    assert.equal(await number(page, 'boxes'), counters.refits);
    assert.equal(await number(page, 'vertices'), counters.posed_vertices);
    assert.equal(await number(page, 'tests'), counters.triangle_pairs);
    assert.ok((await pixels(page, SEGMENTS)).count > 20, 'the segments are in the picture');
    assert.deepEqual(page.complaints, []);
    await page.context().close();
  }
});

const totalIs = (page, { totals }) =>
  page.waitForSelector(`[data-fact=total]:text-is("${totals.contacts.toLocaleString('en')}")`);

test('a report of one character says where it touches itself', async (t) => {
  const models = { walker: { creature: { triangles: 2000, joints: 45, seed: 5 } } };
  const shop = new Workshop(t, {
    models,
    frames: SCENE.frames,
    instances: [{ model: 'walker', clip: 'walk' }],
  });
  const answer = shop.check('--self-rings', '1', '--self-near-joints', 'keep');
  assert.ok(answer.totals.contacts > 0, 'a character worth testing');
  const opened = process.env.PELT_PICTURES ? open : openToCount;
  const page = await opened(t, browsing.urlOf(shop.at('report.html')));
  await agreesWith(page, answer);
  await says(page, 'Check failed');
  await says(
    page,
    `${Object.values(answer.totals.left_out).reduce((a, b) => a + b)} self-contacts dropped`,
  );
  if (process.env.PELT_PICTURES) await picture(page, 'report_self');
  shop.check('--self=no', '--allow-empty');
  const none = await openToCount(t, browsing.urlOf(shop.at('report.html')));
  await says(none, 'the page agrees');
  await none.locator('.nothing').filter({ hasText: 'Nothing was compared' }).waitFor();
});

test('a report says where the page finds something else', async (t) => {
  const shop = new Workshop(t, { ...SCENE, self: true });
  const { hash, totals } = shop.check();
  shop.edit((data) => data.replace(hash, '0123456789abcdef'));
  await says(await openToCount(t, browsing.urlOf(shop.at('report.html'))), 'the page differs');
  shop.check();
  const { at_rest: dropped } = totals.left_out;
  assert.ok(dropped > 0, 'a filter worth testing');
  shop.edit((data) => data.replace(`"at_rest":${dropped}`, `"at_rest":${dropped + 1}`));
  await says(await openToCount(t, browsing.urlOf(shop.at('report.html'))), 'the page differs');
  const [{ a }] = shop.check('--first').touches;
  shop.edit((data) => data.replace(`"part":"${a.part}"`, '"part":"another"'));
  await says(await openToCount(t, browsing.urlOf(shop.at('report.html'))), 'the page differs');
});

test('a report that the page cannot read says why', async (t) => {
  const shop = new Workshop(t);
  shop.check();
  const page = await browser.newPage();
  page.setDefaultTimeout(browsing.PATIENCE);
  t.after(() => page.close());
  await page.addInitScript(browsing.hideWebGL);
  const edits = [
    [(data) => data.replace(/"pelt":"[^"]*"/, '"pelt":"0.0.9"'), /by Pelt 0\.0\.9/],
    [(data) => data.slice(0, 99), /truncated or damaged/],
  ];
  for (const [edit, words] of edits) {
    shop.edit(edit);
    await page.goto(browsing.urlOf(shop.at('report.html')));
    await page.locator('.problem').filter({ hasText: words }).waitFor();
  }
});

test('the demo leaves a report that agrees', async (t) => {
  const shop = new Workshop(t);
  shop.run('demo', '--no-picture', '-o', 'demo');
  const { size } = statSync(shop.at('demo/report.html'));
  assert.ok(size < TEN_MEGABYTES, `${size} bytes`);
  await says(await openToCount(t, browsing.urlOf(shop.at('demo/report.html'))), 'the page agrees');
});

const walkers = path.join(process.env.PELT_SHARED_DIR ?? '', 'scenes/two_walkers.json');
test(
  'that of two walkers is small',
  { skip: !existsSync(walkers) && 'no two_walkers.json' },
  (t) => {
    const shop = new Workshop(t);
    shop.run('check', walkers, '--html', 'report.html');
    const { size } = statSync(shop.at('report.html'));
    assert.ok(size < TEN_MEGABYTES, `${size} bytes`);
  },
);

test('`pelt view` and a dropped scene leave out what the scene ignores', async (t) => {
  const scene = { ...SCENE, ignore: IGNORE };
  const shop = new Workshop(t, scene);
  const answer = shop.check();
  const agrees = async (page) => {
    await counted(page);
    assert.equal(await fact(page, 'hash'), answer.hash);
    assert.equal(await number(page, 'ignored'), answer.totals.ignored);
  };
  const page = await openToCount(t, shop.view('scene.json'));
  await page.locator('.choice button', { hasText: 'whole clip' }).click();
  await agrees(page);
  assert.equal(await report(page).count(), 0);

  await dropFiles(page, [
    { name: 'dropped.json', bytes: readFileSync(shop.at('scene.json')) },
    { name: 'cairn.gltf', bytes: STONES },
  ]);
  await page.waitForSelector('.subject:has-text("dropped.json")');
  await agrees(page);
  assert.deepEqual((await savedScene(page)).ignore, IGNORE);
});
