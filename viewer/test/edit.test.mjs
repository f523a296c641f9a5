// Edits of a scene: all can be undone, and the picture stays while the page counts again.

import assert from 'node:assert/strict';
import path from 'node:path';
import { after, before, describe, test } from 'node:test';
import * as browsing from './browser.mjs';
import { check } from './command.mjs';
import { character } from './models.mjs';

const { answered, counted, dropFiles, fact, goToFrame, number, pixels, savedScene } = browsing;
const built = path.resolve(process.env.PELT_PAGE ?? 'dist/index.html');
const files = { 'body.glb': character('body'), 'coat.glb': character('coat') };
const SMALL = { viewport: { width: 900, height: 560 }, reducedMotion: 'reduce' };

let browser, page, original;
before(async () => {
  browser = await browsing.launch();
  page = await browsing.openPage(browser, browsing.urlOf(built), SMALL, [watchDrawing]);
  await dropFiles(
    page,
    Object.entries(files).map(([name, bytes]) => ({ name, bytes })),
  );
  await page.waitForSelector('.subject:has-text("body.glb, coat.glb"):not(:has-text("reading"))');
  await counted(page);
  original = await fact(page, 'hash');
});
after(() => browser.close());

/** Runs in the page: counts draws to the screen within animation frames and outside, and stills. */
function watchDrawing() {
  window.drawing = { within: 0, outside: 0, stills: 0 };
  let isInFrame = false;
  let target = null;
  const spy = (prototype, name, note) => {
    const real = prototype[name];
    prototype[name] = function (...given) {
      note(...given);
      return real.apply(this, given);
    };
  };
  const request = window.requestAnimationFrame;
  window.requestAnimationFrame = (call) =>
    request((time) => {
      isInFrame = true;
      call(time);
      isInFrame = false;
    });
  const gl = WebGL2RenderingContext.prototype;
  spy(gl, 'bindFramebuffer', (kind, buffer) => {
    if (kind !== WebGL2RenderingContext.READ_FRAMEBUFFER) target = buffer;
  });
  spy(gl, 'drawElements', () => {
    if (target === null) ++window.drawing[isInFrame ? 'within' : 'outside'];
  });
  spy(HTMLCanvasElement.prototype, 'toDataURL', () => ++window.drawing.stills);
}

const drawing = () => page.evaluate(() => window.drawing);
const card = (index) => page.locator('.card').nth(index);
const field = (label) => page.locator('.card.selected').getByLabel(label, { exact: true });
const arrangement = () => page.getByLabel('arrangement').inputValue();
const button = (name) => page.getByRole('button', { name, exact: true });
const hashIs = (hash) => page.waitForSelector(`[data-fact=hash]:text-is("${hash}")`);

/** Waits for another hash, which the command finds, too; returns it. */
async function countedAnew(t, before) {
  await page.waitForSelector(`[data-fact=hash]:not(:text-is("${before}"))`);
  const { hash } = check(t, await savedScene(page), files);
  assert.equal(await fact(page, 'hash'), hash);
  return hash;
}

describe('stills', () => {
  test('are not taken while they are not shown', async () => {
    await page.keyboard.press('0');
    await field('x').fill('0.15');
    await hashIs(await countedAnew({ after }, original));
    await page.waitForTimeout(300);
    assert.equal((await drawing()).stills, 0);
  });

  test('never touch the picture on the screen', async () => {
    await button('whole clip').click();
    await page.waitForSelector('.stills img');
    const { within, outside, stills } = await drawing();
    assert.equal(stills, await page.locator('.stills img').count());
    assert.equal(outside, 0);
    assert.ok(within > 0, 'the counter counts');
    const still = await pixels(page, browsing.GLOWING, page.locator('.stills img').first());
    assert.ok(still.count > 5, `${still.count} pixels glow`);
    assert.ok(still.colours > 100, `${still.colours} colours`);
    await button('this frame').click();
  });
});

describe('an edit', () => {
  test('leaves the placement to be chosen again', async () => {
    assert.equal(await arrangement(), 'changed');
    await page.getByLabel('arrangement').selectOption('walking');
    await hashIs(original);
    assert.equal(await arrangement(), 'walking');
  });

  test('is undone by Ctrl+Z and by a button, as a whole', async (t) => {
    await page.keyboard.press('0');
    const x = await field('x').inputValue();
    await field('x').focus();
    await page.keyboard.press('Control+A');
    await field('x').pressSequentially('-0.25', { delay: 30 });
    const moved = await countedAnew(t, original);
    await page.keyboard.press('Control+z');
    await hashIs(original);
    assert.equal(await field('x').inputValue(), x);
    await page.keyboard.press('Control+y');
    await hashIs(moved);
    await button('Undo').click();
    await hashIs(original);
    assert.equal(await arrangement(), 'walking');
  });

  test('of the gizmo is undone as a whole', async () => {
    await goToFrame(page, 0);
    await page.keyboard.press('c');
    await page.waitForTimeout(600); // until the camera has arrived
    await browsing.dragGizmo(page);
    await page.waitForSelector(`[data-fact=hash]:not(:text-is("${original}"))`);
    await page.keyboard.press('Control+z');
    await hashIs(original);
  });

  test('keeps a turn as it is typed', async () => {
    await field('turn °').focus();
    await page.keyboard.press('Control+A');
    await field('turn °').pressSequentially('270.5', { delay: 30 });
    assert.equal(await field('turn °').inputValue(), '270.5');
    await page.keyboard.press('Tab');
    assert.equal(await field('turn °').inputValue(), '-89.5');
    await page.keyboard.press('Control+z');
    await hashIs(original);
    await page.keyboard.press('Escape');
  });
});

describe('a character', () => {
  test('is copied, and removed by a key', async (t) => {
    await page.keyboard.press('1');
    await button('Duplicate').click();
    await card(2).waitFor();
    assert.match(await page.locator('.card.selected').innerText(), /^2\s*coat\.glb/);
    await field('x').fill('0.05');
    await countedAnew(t, original);
    assert.equal((await savedScene(page)).instances.length, 3);
    await page.keyboard.press('Escape');
    await page.keyboard.press('2');
    await page.keyboard.press('Delete');
    await card(2).waitFor({ state: 'detached' });
    await hashIs(original);
    await button('Undo').click();
    await card(2).waitFor();
    await button('Remove').click();
    await hashIs(original);
  });

  test('is removed by a button, unless it is the only one', async () => {
    await page.keyboard.press('0');
    await button('Remove').click();
    await card(1).waitFor({ state: 'detached' });
    assert.match(await page.locator('.subject').innerText(), /^coat\.glb$/);
    await page.waitForSelector('[data-fact=total]:text-is("0")');
    assert.equal(await page.locator('.nothing').innerText(), 'Nothing touches in any frame.');
    await page.keyboard.press('x');
    const none =
      'Nothing was compared: the scene has fewer than two characters, and “self” is off.';
    await page.locator('.nothing').filter({ hasText: none }).waitFor();
    await counted(page);
    assert.match(await page.locator('.facts').innerText(), /0 contacts .*· nothing was compared/);
    assert.deepEqual(Object.keys((await savedScene(page)).models), ['coat.glb']);
    await page.keyboard.press('0');
    assert.ok(await button('Remove').isDisabled());
    await page.keyboard.press('Control+z');
    await hashIs(original);
  });

  test('is hidden in the picture, and counts all the same', async () => {
    await page.keyboard.press('1');
    await page.keyboard.press('h');
    await page.locator('.card.selected').filter({ hasText: 'hidden' }).waitFor();
    await page.keyboard.press('0');
    const one = await pixels(page);
    await button('Hide').click();
    await page.keyboard.press('Escape');
    const none = await pixels(page);
    assert.ok(none.colours < 0.8 * one.colours, `${none.colours} of ${one.colours} colours`);
    assert.equal(await fact(page, 'hash'), original);
    for (const key of ['0', 'h', '1', 'h', 'Escape']) await page.keyboard.press(key);
    assert.equal(await page.locator('.card').filter({ hasText: 'hidden' }).count(), 0);
  });
});

test('a click on the bar of a frame goes to this frame', async () => {
  await page.getByLabel('frames', { exact: true }).fill('40');
  const { x, y, width, height } = await page.locator('.chart').boundingBox();
  for (const [frame, share] of [
    [30, 0.1],
    [2, 0.9],
    [0, 0.02],
    [39, 0.98],
  ]) {
    await page.mouse.click(x + ((frame + share) / 40) * width, y + height / 2);
    await answered(page, frame);
    assert.equal(await number(page, 'frame'), frame);
  }
});

test('characters that never touch can be put in the same place', async () => {
  await page.keyboard.press('0');
  await field('x').fill('9');
  await page.locator('.nothing').filter({ hasText: 'Nothing touches in any frame.' }).waitFor();
  assert.ok(await button('Next contact').isDisabled());
  assert.match(await page.locator('.facts').innerText(), /0 contacts in 0 of 40 frames/);
  await button('Put all in the same place').click();
  await page.waitForSelector('[data-fact=total]:not(:text-is("0"))');
  assert.equal(await arrangement(), 'together');
  assert.ok(await button('Next contact').isEnabled());
});

test('the play button stays visible under the mouse', async () => {
  await button('Play').hover();
  await page.waitForTimeout(200);
  const [ink, back] = await button('Play').evaluate((play) => {
    const { color, backgroundColor } = getComputedStyle(play);
    return [color, backgroundColor].map((text) => text.match(/\d+/g).map(Number));
  });
  const luminance = (rgb) => {
    const [r, g, b] = rgb.map((value) => (value / 255) ** 2.2);
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
  };
  const [dark, light] = [luminance(ink), luminance(back)].sort((one, other) => one - other);
  assert.ok((light + 0.05) / (dark + 0.05) > 4.5, `${ink} on ${back}`);
});

test('nothing went wrong', () => assert.deepEqual(page.complaints, []));
