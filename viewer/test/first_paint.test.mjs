// The page shows panels, the verdict of a report and the theme of the system before the picture. If
// the script does not run, the page shows text.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { after, before, test } from 'node:test';
import * as browsing from './browser.mjs';
import { Workshop } from './reports.mjs';

let browser;
const shop = new Workshop({ after });
before(async () => {
  browser = await browsing.launch();
  shop.check();
});
after(() => browser.close());

/** Runs in the page: notes what has been painted when the first WebGL context is requested. */
function watchContext() {
  const { getContext } = HTMLCanvasElement.prototype;
  HTMLCanvasElement.prototype.getContext = function (kind, ...options) {
    if (kind.startsWith('webgl')) {
      window.paintedFirst ??= {
        text: document.getElementById('panels').innerText,
        time: performance.now(),
        back: getComputedStyle(document.body).backgroundImage,
      };
    }
    return getContext.call(this, kind, ...options);
  };
}

test('the verdict of a report, in the theme of the system, comes before WebGL', async (t) => {
  for (const [colorScheme, back] of [
    ['light', /rgb\(251, 250, 248\)/],
    ['dark', /rgb\(52, 58, 67\)/],
  ]) {
    const context = await browser.newContext({ colorScheme, reducedMotion: 'reduce' });
    t.after(() => context.close());
    const page = await context.newPage();
    await page.addInitScript(browsing.blurCoarsely);
    await page.addInitScript(watchContext);
    await page.goto(browsing.urlOf(shop.at('report.html')));
    const seen = await (await page.waitForFunction(() => window.paintedFirst)).jsonValue();
    assert.match(seen.text, /Check failed[^]*Contact in \d+ of 12 frames/);
    const paint = await page.waitForFunction(() => {
      return performance.getEntriesByName('first-contentful-paint')[0]?.startTime;
    });
    const painted = await paint.jsonValue();
    assert.ok(painted < seen.time, `painted at ${painted} ms, WebGL at ${seen.time} ms`);
    assert.match(seen.back, back);
    assert.equal(await page.locator('html').getAttribute('data-theme'), null);
  }
});

test('without JavaScript, a report has its verdict, and says what it needs', async (t) => {
  const context = await browser.newContext({ javaScriptEnabled: false });
  t.after(() => context.close());
  const page = await context.newPage();
  await page.goto(browsing.urlOf(shop.at('report.html')));
  const text = await page.locator('body').innerText();
  assert.match(text, /^Pelt\s+Check failed: \d+ of 12 frames in contact, [\d,]+ contacts\./);
  assert.match(text, /This page needs JavaScript/);
});

test('a report that was cut short says so', async (t) => {
  const whole = readFileSync(shop.at('report.html'), 'utf8');
  const data = whole.indexOf('id="pelt-data"');
  writeFileSync(shop.at('cut.html'), whole.slice(0, data + 2000));
  const page = await browser.newPage();
  t.after(() => page.close());
  await page.goto(browsing.urlOf(path.resolve(shop.at('cut.html'))));
  await page.locator('.opening').filter({ hasText: 'cut short' }).waitFor();
});
