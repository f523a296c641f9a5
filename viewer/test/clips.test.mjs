// Reports of all clips: the page lets the reader choose one, and finds in each what the command found.

import assert from 'node:assert/strict';
import { writeFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import * as browsing from './browser.mjs';
import { SCENE, STONES, Workshop } from './reports.mjs';

let browser;
before(async () => (browser = await browsing.launch()));
after(() => browser.close());

/** The stones play all their clips: they stand, and then roll into each other. */
function workshopOfClips(t) {
  const instances = SCENE.instances.map((one) => ({ ...one, clip: '*' }));
  const shop = new Workshop(t, { ...SCENE, frames: { fps: 12 }, instances });
  const stones = JSON.parse(STONES);
  const [roll] = stones.animations;
  stones.animations = [{ ...roll, name: 'stand', channels: [roll.channels[0]] }, roll];
  writeFileSync(shop.at('models/cairn.gltf'), JSON.stringify(stones));
  return shop;
}

async function open(t, url) {
  const page = await browsing.openToCount(browser, url);
  t.after(() => page.context().close());
  return page;
}

const clips = (page) => page.locator('section:has(#clips)');
const rowOf = (page, clip) => clips(page).getByRole('button', { name: clip });

test('a report of all clips opens the worst one, and shows each of them', async (t) => {
  const shop = workshopOfClips(t);
  // Every other frame: the frames of the second clip do not start at its first.
  const answer = shop.check('--frames', '1:24:2');
  const worst = answer.clips.reduce((one, other) =>
    other.worst.contacts > one.worst.contacts ? other : one,
  );
  assert.equal(answer.clips.length, 2);
  assert.equal(worst.clip, 'roll', 'the worst clip is not the first');
  const page = await open(t, browsing.urlOf(shop.at('report.html')));
  await rowOf(page, 'roll').and(page.locator('[aria-pressed=true]')).waitFor();
  assert.equal(await browsing.number(page, 'frame'), worst.worst.clip_frame);
  for (const { clip, contacts, frames, frames_in_contact: inContact } of answer.clips) {
    const row = rowOf(page, clip);
    assert.match(await row.innerText(), new RegExp(`${inContact} of ${frames} frames`));
    await row.click();
    await row.and(page.locator('[aria-pressed=true]')).waitFor();
    await page.locator('section:has(#report)', { hasText: 'the page agrees' }).waitFor();
    assert.equal(await browsing.number(page, 'total'), contacts, clip);
    assert.match(await page.locator('.lead').innerText(), new RegExp(`clip ${clip}`));
    assert.deepEqual(
      (await browsing.savedScene(page)).instances.map((one) => one.clip),
      [clip, clip],
    );
  }
  assert.deepEqual(page.complaints, []);
});

test('the page says if a clip of a report has other contacts', async (t) => {
  const shop = workshopOfClips(t);
  shop.check();
  shop.edit((text) => {
    const data = JSON.parse(text);
    const [first] = data.answer.touches.filter(({ clip }) => clip === 'roll');
    ++first.contacts;
    return JSON.stringify(data);
  });
  const page = await open(t, browsing.urlOf(shop.at('report.html')));
  const report = page.locator('section:has(#report)');
  await report.filter({ hasText: 'the page differs' }).waitFor();
  await rowOf(page, 'stand').click();
  await report.filter({ hasText: 'the page agrees' }).waitFor();
});

test('pelt view plays each of all clips', async (t) => {
  const shop = workshopOfClips(t);
  const page = await open(t, shop.view('scene.json'));
  await rowOf(page, 'stand').and(page.locator('[aria-pressed=true]')).waitFor();
  await rowOf(page, 'roll').click();
  await rowOf(page, 'roll').and(page.locator('[aria-pressed=true]')).waitFor();
  assert.equal((await browsing.savedScene(page)).instances[1].clip, 'roll');
  assert.deepEqual(page.complaints, []);
});
