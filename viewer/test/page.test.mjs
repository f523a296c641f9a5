// The page in a real browser shows what the command finds.

import assert from 'node:assert/strict';
import { mkdirSync } from 'node:fs';
import path from 'node:path';
import { after, before, describe, test } from 'node:test';
import * as browsing from './browser.mjs';
import { check, posedWalker } from './command.mjs';
import { announcements } from './reading.mjs';

const {
  answered,
  counted,
  dragGizmo,
  dropFiles,
  fact,
  focused,
  goToFrame,
  number,
  pixels,
  savedScene,
} = browsing;
const built = path.resolve(process.env.PELT_PAGE ?? 'dist/index.html');
const pictures = process.env.PELT_PICTURES;

/** Frames of the walkers: the first has no contact, the second has many. */
const APART = 0;
const TOGETHER = 90;

/** A frame that shows much. */
const MEETING = 80;
const PICTURE = { width: 1280, height: 760 };

let browser, server, page;
before(async () => {
  browser = await browsing.launch();
  server = await browsing.serve(built);
});
after(async () => {
  await browser.close();
  server.close();
});

const isOwn = (url) => /^(data|blob):/.test(url);

test('the page opens over HTTP, with contacts', async () => {
  const served = await browsing.openPage(browser, server.url);
  assert.ok((await number(served, 'total')) > 0);
  assert.ok(served.fetched.every((url) => url.startsWith(server.url) || isOwn(url)));
  assert.deepEqual(served.complaints, []);
  await served.close();
});

describe('the page from disk', () => {
  before(async () => (page = await browsing.openPage(browser, browsing.urlOf(built))));

  test('opens with walkers that play', async () => {
    const first = await number(page, 'frame');
    await page.waitForFunction((frame) => {
      return Number(document.querySelector('[data-fact=frame]').textContent) !== frame;
    }, first);
    assert.equal(await announcements(page), 0, 'screen readers are not flooded');
    await page.keyboard.press('Space');
    await page.waitForSelector('[aria-label=Play]');
    await page
      .locator('[role=status]')
      .filter({ hasText: /^frame \d+: [\d,]+ contacts?$/ })
      .waitFor();
    assert.equal(await page.locator('.card').count(), 2);
  });

  test('says what is looked at, in regions with plain names', async () => {
    assert.match(
      await page.locator('.lead').innerText(),
      /^Orange marks every triangle of one character that [^.]*180 frames of two generated/,
    );
    for (const name of ['Characters', 'Work', 'Contacts']) {
      assert.equal(await page.getByRole('region', { name, exact: true }).count(), 1, name);
    }
  });

  test('finds the contacts that the command finds', async (t) => {
    const answer = check(t, await savedScene(page));
    assert.equal(await number(page, 'total'), answer.totals.contacts);
    assert.equal(await fact(page, 'hash'), answer.hash);
    assert.ok(answer.counts[APART] === 0 && answer.counts[TOGETHER] > 100, 'a scene worth testing');
    for (const frame of [APART, 70, TOGETHER, answer.counts.length - 1]) {
      await goToFrame(page, frame);
      assert.equal(await number(page, 'contacts'), answer.counts[frame], `frame ${frame}`);
    }
  });

  test('draws contacts where there are some', async () => {
    await goToFrame(page, APART);
    const apart = await pixels(page);
    await goToFrame(page, TOGETHER);
    const together = await pixels(page);
    assert.ok(apart.colours > 500, `${apart.colours} colours`);
    assert.equal(apart.count, 0);
    assert.ok(together.count > 200, `${together.count} pixels glow`);
  });

  test("tells the work, which is the command's, and less than refitting all", async (t) => {
    await goToFrame(page, TOGETHER);
    await page.getByRole('button', { name: 'Work', exact: true }).click();
    const { counters } = check(t, await savedScene(page), {}, [
      '--frames',
      `${TOGETHER}:${TOGETHER + 1}`,
    ]);
    assert.equal(await number(page, 'boxes'), counters.refits);
    assert.equal(await number(page, 'vertices'), counters.posed_vertices);
    assert.equal(await number(page, 'tests'), counters.triangle_pairs);
    await page.waitForSelector('.work tr:not(.earlier) [data-fact=microseconds]:not(:text("–"))');
    for (const name of ['boxes', 'vertices', 'nodes']) {
      const [some, all] = [await number(page, name), await number(page, `all-${name}`)];
      assert.ok(some > 0 && some < all, `${name}: ${some} of ${all}`);
    }
    assert.ok((await number(page, 'all-tests')) > 0);
    assert.ok((await number(page, 'microseconds')) > 0);
    assert.match(await page.locator('h2:has(#work)').innerText(), /faster|slower|as fast/);
    await page.getByRole('button', { name: 'Work', exact: true }).click();
    await page.locator('.work').waitFor({ state: 'detached' });
  });

  test('lists the joints that touch', async () => {
    await goToFrame(page, TOGETHER);
    const counts = await page.locator('.touches .count').allInnerTexts();
    assert.ok(counts.length > 1);
    assert.ok(counts.every((count) => Number(count) > 0));
  });
});

describe('the keyboard', () => {
  const press = (key) => page.keyboard.press(key);
  const atFrame = (frame) => page.waitForSelector(`[data-fact=frame]:text-is("${frame}")`);

  test('stops, steps and jumps to contacts', async () => {
    await press('Space');
    await page.waitForSelector('[aria-label=Pause]');
    await press('Space');
    await page.waitForSelector('[aria-label=Play]');
    await press('Home');
    await atFrame(0);
    await press('ArrowRight');
    await atFrame(1);
    await press('n');
    await page.waitForSelector('[data-fact=frame]:not(:text-is("1"))');
    const first = await number(page, 'frame');
    await answered(page, first);
    assert.ok(first > 1 && (await number(page, 'contacts')) > 0);
    await press('ArrowLeft');
    await answered(page, first - 1);
    assert.equal(await number(page, 'contacts'), 0);
    await press('n');
    await atFrame(first);
  });

  test('selects a character', async () => {
    await press('1');
    await page.waitForSelector('.card.selected:has-text("sand")');
    await press('Escape');
    await page.locator('.card.selected').waitFor({ state: 'detached' });
  });

  test('draws bounds, of which some are opened and some untouched', async () => {
    await goToFrame(page, TOGETHER);
    const without = [];
    for (const colour of [browsing.BLUE, browsing.RED]) {
      without.push([colour, (await pixels(page, colour)).count]);
    }
    await press('b');
    await press(']');
    await page.waitForSelector('.level:has-text("level 4")');
    await page.waitForFunction(() => {
      const legend = document.querySelector('.legend').innerText;
      return /[1-9]\d* opened[^]*[1-9]\d* untouched/.test(legend);
    });
    for (const [colour, count] of without) {
      const more = (await pixels(page, colour)).count - count;
      assert.ok(more > 100, `${more} more pixels of ${JSON.stringify(colour)}`);
    }
  });

  test('shows what is shown, and the keys', async () => {
    await press('?');
    const dialog = page.getByRole('dialog', { name: 'Help' });
    await dialog.waitFor();
    assert.match(await dialog.innerText(), /Opened: [^]*Untouched: [^]*next frame/);
    const closings = [() => press('Escape'), () => press('?'), () => page.mouse.click(9, 300)];
    for (const close of closings) {
      await close();
      await dialog.waitFor({ state: 'hidden' });
      await press('?');
      await dialog.waitFor();
    }
    await press('Escape');
  });

  test('reaches every control, and shows where it is', async () => {
    const reached = new Set();
    for (let i = 0; i < 40; ++i) {
      await press('Tab');
      reached.add(await focused(page));
    }
    for (const name of [
      'Open files',
      'Save scene',
      'Play',
      'Next contact',
      'Whole scene',
      'Draw bounds',
    ]) {
      assert.ok(reached.has(`${name}: solid`), `${name} in ${[...reached]}`);
    }
  });
});

test(
  'the page can be looked at',
  { skip: !pictures && 'PELT_PICTURES names no folder' },
  async () => {
    mkdirSync(pictures, { recursive: true });
    await page.setViewportSize(PICTURE);
    const take = async (name) => {
      await answered(page, MEETING);
      await page.waitForTimeout(1000);
      await page.screenshot({ path: path.join(pictures, `viewer_${name}.png`) });
    };
    await goToFrame(page, MEETING);
    await page.locator('[aria-label=Frame]').blur();
    await page.keyboard.press('[');
    await page.locator('.touches').evaluate((list) => (list.scrollTop = 0));
    await take('dark_bounds');
    await page.keyboard.press('t');
    await take('light_bounds');
    await page.keyboard.press('b');
    await take('light');
    await page.keyboard.press('t');
    await take('dark');
  },
);

describe('the scene changes', () => {
  test('a character that is moved has the contacts that the command finds', async (t) => {
    await goToFrame(page, TOGETHER);
    const contacts = await number(page, 'contacts');
    await page.keyboard.press('0');
    await page.getByLabel('x', { exact: true }).fill('-0.05');
    await answered(page, TOGETHER);
    assert.notEqual(await number(page, 'contacts'), contacts);
    const scene = await savedScene(page);
    assert.equal(scene.instances[0].translation[0], -0.05);
    await agreesWith(check(t, scene));
  });

  test('so has one that the gizmo has moved', async (t) => {
    const place = page.getByLabel('x', { exact: true });
    const from = Number(await place.inputValue());
    await dragGizmo(page);
    assert.notEqual(Number(await place.inputValue()), from);
    await agreesWith(check(t, await savedScene(page)));
  });

  test('first contacts are those of --first', async (t) => {
    const scene = await savedScene(page);
    await page.keyboard.press('f');
    await answered(page, TOGETHER);
    const { counts, totals } = check(t, scene, {}, ['--first']);
    assert.equal(await number(page, 'contacts'), counts[TOGETHER]);
    await counted(page);
    assert.equal(await number(page, 'total'), totals.contacts);
    assert.equal(await page.locator('[data-fact=hash]').count(), 0);
    await page.keyboard.press('f');
  });

  async function agreesWith({ counts, hash }) {
    await answered(page, TOGETHER);
    assert.equal(await number(page, 'contacts'), counts[TOGETHER]);
    await counted(page);
    assert.equal(await fact(page, 'hash'), hash);
  }
});

describe('files', () => {
  test('a bad one is named, with what is wrong, and the scene stays', async () => {
    const contacts = await fact(page, 'total');
    await dropFiles(page, [
      { name: 'torn.glb', bytes: Buffer.from('glTF, but no more than that') },
    ]);
    const problem = page.locator('.problem');
    assert.match(await problem.innerText(), /torn\.glb[^]*\w{4,}/);
    assert.equal(await fact(page, 'total'), contacts);
    await problem.getByRole('button', { name: 'Dismiss' }).click();
    await problem.waitFor({ state: 'detached' });
  });

  test('a bad one among good ones is left out, and named alone', async (t) => {
    const bytes = posedWalker(t);
    await dropFiles(page, [
      { name: 'torn.glb', bytes: Buffer.from('glTF, but no more than that') },
      { name: 'good.glb', bytes },
    ]);
    await page.waitForSelector('.card:has-text("good.glb")');
    assert.match(await page.locator('.problem strong').innerText(), /^torn\.glb was left out$/);
    await page.getByRole('button', { name: 'Dismiss' }).click();
  });

  test('one that is no character is refused', async () => {
    await dropFiles(page, [{ name: 'notes.txt', bytes: Buffer.from('walk left') }]);
    assert.match(await page.locator('.problem').innerText(), /notes\.txt[^]*\.glb/);
    await page.getByRole('button', { name: 'Dismiss' }).click();
  });

  test('a character that is dropped stands alone, as in the command', async (t) => {
    const bytes = posedWalker(t);
    await dropFiles(page, [{ name: 'walker.glb', bytes }]);
    await page.waitForSelector('.card:has-text("walker.glb")');
    await counted(page);
    const scene = await savedScene(page);
    const answer = check(t, scene, { 'walker.glb': bytes });
    assert.equal(scene.instances.length, 1);
    assert.equal(await fact(page, 'hash'), answer.hash);
    assert.match(await page.locator('.lead').innerText(), /its own character, in 1 frame/);
  });

  test('another joins it when Shift is held, and what is no character does not', async (t) => {
    const shiftKey = true;
    await dropFiles(page, [{ name: 'notes.txt', bytes: Buffer.from('walk left') }], { shiftKey });
    assert.match(await page.locator('.problem').innerText(), /Only characters can be added/);
    await page.getByRole('button', { name: 'Dismiss' }).click();
    const before = { 'walker.glb': posedWalker(t), 'second.glb': posedWalker(t) };
    await dropFiles(page, [{ name: 'second.glb', bytes: before['second.glb'] }], { shiftKey });
    await page.waitForSelector('.card.selected:has-text("second.glb")');
    await counted(page);
    const scene = await savedScene(page);
    assert.deepEqual(
      scene.instances.map(({ model }) => model),
      ['walker.glb', 'second.glb'],
    );
    assert.equal(await fact(page, 'hash'), check(t, scene, before).hash);
  });

  test('a scene that is dropped with its files is the one that was saved', async (t) => {
    const bytes = posedWalker(t);
    const scene = await savedScene(page);
    scene.frames.count = 50;
    const text = Buffer.from(JSON.stringify(scene));
    await dropFiles(page, [
      { name: 'fifty.json', bytes: text },
      { name: 'walker.glb', bytes },
      { name: 'second.glb', bytes },
    ]);
    await page.waitForSelector('.subject:has-text("fifty.json")');
    await counted(page);
    assert.deepEqual(await savedScene(page), scene);
  });
});

test('nothing was fetched, and nothing went wrong', () => {
  assert.deepEqual(
    page.fetched.filter((url) => !isOwn(url)),
    [browsing.urlOf(built)],
  );
  assert.deepEqual(page.complaints, []);
});
