// The look of the page, in light and dark themes and without a picture.

import assert from 'node:assert/strict';
import path from 'node:path';
import { after, before, test } from 'node:test';
import * as browsing from './browser.mjs';

const { answered, counted, fact, goToFrame, number, pixels } = browsing;
const built = path.resolve(process.env.PELT_PAGE ?? 'dist/index.html');
const url = browsing.urlOf(built);

let browser, still;
before(async () => (browser = await browsing.launch()));
after(() => browser.close());

/** Brightness of the page's picture and panels, from 0 to 255. */
function brightness(page) {
  return page.evaluate(() => {
    const [r, g, b] = getComputedStyle(document.body).color.match(/\d+/g).map(Number);
    return 255 - (r + g + b) / 3; // of what the text stands on
  });
}

test('is as dark as the system, and as was chosen the last time', async () => {
  const page = await browsing.openPage(browser, url, {
    colorScheme: 'light',
    reducedMotion: 'reduce',
  });
  assert.ok((await brightness(page)) > 200);
  await page.keyboard.press('t');
  await page.waitForSelector('html[data-theme=dark]');
  assert.ok((await brightness(page)) < 50);
  await page.reload();
  await page.waitForSelector('html[data-theme=dark]');
  await page.close();
});

test('stands still, in contact, where the system asks for little movement', async () => {
  still = await browsing.openPage(browser, url, { reducedMotion: 'reduce', hasTouch: true });
  await still.waitForSelector('[aria-label=Play]');
  const frame = await number(still, 'frame');
  await answered(still, frame);
  assert.ok((await number(still, 'contacts')) > 0);
  await still.waitForTimeout(300);
  assert.equal(await number(still, 'frame'), frame);
});

test('the camera goes where keys send it, and a tap selects', async () => {
  await browsing.photographed(still);
  await goToFrame(still, 90);
  await still.locator('[aria-label=Frame]').blur();
  const seen = async () => (await pixels(still)).count;
  const whole = await seen();
  for (let i = 0; i < 5; ++i) await still.keyboard.press('+');
  const near = await seen();
  assert.ok(near > 1.5 * whole, `${near} glowing pixels of ${whole}`);
  for (let i = 0; i < 9; ++i) await still.keyboard.press('d');
  assert.notEqual(await seen(), near);
  await still.keyboard.press('c');
  assert.equal(await seen(), whole);
  const { x, y } = await pixels(still);
  await still.touchscreen.tap(x, y);
  await still.waitForSelector('.card.selected');
  assert.deepEqual(still.complaints, []);
});

test('without WebGL, says so and counts all the same', async () => {
  const context = await browser.newContext();
  await context.addInitScript(() => {
    HTMLCanvasElement.prototype.getContext = () => null;
  });
  const page = await context.newPage();
  await page.goto(url);
  await page
    .locator('#view')
    .filter({ hasText: /No picture: .*WebGL/ })
    .waitFor();
  await counted(page);
  assert.ok((await number(page, 'total')) > 0);
  assert.match(await fact(page, 'hash'), /^[0-9a-f]{16}$/);
  await page.getByRole('button', { name: 'whole clip' }).click();
  await page.locator('.touch').first().click();
  await page.locator('.triangles').waitFor();
  await context.close();
});
