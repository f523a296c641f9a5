// The page with data in it, as `pelt check --html` leaves it.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { after, before, describe, test } from 'node:test';
import * as browsing from './browser.mjs';
import { check, checkToPage } from './command.mjs';

const PLACE = '<script type="application/json" id="pelt-data">';

const scene = {
  models: { small: { creature: { triangles: 1664, joints: 45, seed: 3 } } },
  frames: { count: 12, fps: 12 },
  instances: [
    { model: 'small', clip: 'walk', translation: [0, 0, -0.5], velocity: [0, 0, 1] },
    {
      model: 'small',
      clip: 'walk',
      translation: [0.1, 0, 0.5],
      rotation: [0, 1, 0, 0],
      velocity: [0, 0, -1],
    },
  ],
};

/** What `pelt check --html` leaves, its data changed by `change`. */
function writeReport(t, change = (report) => report) {
  const file = checkToPage(t, scene);
  const [head, rest] = readFileSync(file, 'utf8').split(PLACE);
  const end = rest.indexOf('</script>');
  const data = JSON.stringify(change(JSON.parse(rest.slice(0, end))));
  writeFileSync(file, head + PLACE + data.replaceAll('<', '\\u003c') + rest.slice(end));
  return browsing.urlOf(file);
}

describe('a report', () => {
  let browser;
  before(async () => (browser = await browsing.launch()));
  after(() => browser.close());

  test('plays the scene and finds what the command found', async (t) => {
    const page = await browsing.openPage(browser, writeReport(t));
    const report = page.locator('section:has(#report)');
    assert.match(await report.innerText(), /the page agrees[^]*pelt check [^]*scene\.json --html/);
    assert.equal(await browsing.fact(page, 'hash'), check(t, scene).hash);
    assert.equal(await page.locator('.card').count(), 2);
    assert.deepEqual(page.complaints, []);
  });

  test('tells which of many instances touch', async (t) => {
    const third = { ...scene.instances[0], translation: [9, 0, 0], velocity: [0, 0, 0] };
    const crowd = { ...scene, instances: [...scene.instances, third] };
    const page = await browsing.openPage(browser, browsing.urlOf(checkToPage(t, crowd)));
    await page.locator('.choice button', { hasText: 'whole clip' }).click();
    const rows = await page.locator('.pairs tr').allInnerTexts();
    const { contacts } = check(t, crowd).totals;
    assert.equal(rows.length, 1);
    assert.match(
      rows[0],
      new RegExp(`0\\s*small\\s+1\\s*small\\s+${contacts.toLocaleString('en')}`),
    );
  });

  test('says where it finds something else', async (t) => {
    const url = writeReport(t, (report) => {
      ++report.answer.counts[5];
      return report;
    });
    const page = await browsing.openPage(browser, url);
    assert.match(await page.locator('section:has(#report)').innerText(), /the page differs/);
  });
});
