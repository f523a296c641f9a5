// The page with data in it, as `pelt check --html` leaves it.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { after, before, describe, test } from 'node:test';
import * as browsing from './browser.mjs';
import { check, temporaryFolder } from './command.mjs';

const built = path.resolve(process.env.PELT_PAGE ?? 'dist/index.html');
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

/** The page with the command's answer to the scene, changed by `change`. */
function writeReport(t, change = (report) => report) {
  const { counts, hash } = check(t, scene);
  const report = change({
    format: 'pelt-report',
    version: 1,
    command: 'pelt check <scene.json>',
    scene: 'scene.json',
    files: { 'scene.json': Buffer.from(JSON.stringify(scene)).toString('base64') },
    reading: {},
    firstContact: false,
    answer: { frames: [0, 12, 1], counts, hash },
  });
  const data = JSON.stringify(report).replaceAll('<', '\\u003c');
  const file = path.join(temporaryFolder(t), 'report.html');
  writeFileSync(
    file,
    readFileSync(built, 'utf8').replace(PLACE, () => PLACE + data),
  );
  return browsing.urlOf(file);
}

describe('a report', () => {
  let browser;
  before(async () => (browser = await browsing.launch()));
  after(() => browser.close());

  test('plays the scene and finds what the command found', async (t) => {
    const page = await browsing.openPage(browser, writeReport(t));
    const report = page.locator('section:has(#report)');
    assert.match(await report.innerText(), /the page agrees[^]*pelt check <scene\.json>/);
    assert.equal(await browsing.fact(page, 'hash'), check(t, scene).hash);
    assert.equal(await page.locator('.card').count(), 2);
    assert.deepEqual(page.complaints, []);
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
