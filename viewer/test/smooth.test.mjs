// Counts the work of the page per frame, which must not grow, whatever the machine.

import assert from 'node:assert/strict';
import path from 'node:path';
import { after, before, describe, test } from 'node:test';
import * as browsing from './browser.mjs';

const { answered, goToFrame, number } = browsing;
const built = path.resolve(process.env.PELT_PAGE ?? 'dist/index.html');

/** Frames of the walkers, all in contact. */
const FIRST = 80;
const FRAMES = 6;

/** The counts do not depend on the size of the window. */
const SMALL = { viewport: { width: 800, height: 420 } };

/** Sizes, in bytes and in vertices, that only the characters reach. */
const LARGE = { upload: 100_000, draw: 10_000 };

/** Runs in the page before its own scripts: counts what they do. */
function countWork({ upload, draw }) {
  const nothing = () => ({ sent: {}, uploads: 0, draws: 0, floats: 0, changed: [] });
  const work = nothing();
  const spy = (prototype, name, note) => {
    const original = prototype[name];
    prototype[name] = function (...given) {
      note(...given);
      return original.apply(this, given);
    };
  };
  spy(Worker.prototype, 'postMessage', ({ kind }) => {
    work.sent[kind] = (work.sent[kind] ?? 0) + 1;
  });
  const gl = WebGL2RenderingContext.prototype;
  spy(gl, 'bufferData', (_, data) => (work.uploads += data.byteLength >= upload));
  spy(gl, 'bufferSubData', (_, __, data) => (work.uploads += data.byteLength >= upload));
  spy(gl, 'drawElements', (_, count) => (work.draws += count >= draw));
  window.Float32Array = new Proxy(Float32Array, {
    construct(real, given, self) {
      const array = Reflect.construct(real, given, self === window.Float32Array ? real : self);
      if (!(given[0] instanceof ArrayBuffer)) work.floats += array.length;
      return array;
    },
  });
  document.addEventListener('DOMContentLoaded', () => {
    new MutationObserver((mutations) => {
      for (const { target } of mutations) {
        const element = target.nodeType === Node.TEXT_NODE ? target.parentElement : target;
        const place = element?.closest('section, footer, header, dialog, .problems, .hover');
        const name = place?.getAttribute('aria-labelledby') ?? place?.className ?? 'page';
        if (!work.changed.includes(name)) work.changed.push(name);
      }
    }).observe(document.getElementById('panels'), {
      attributes: true,
      characterData: true,
      childList: true,
      subtree: true,
    });
  });
  window.takeWork = () => {
    const done = structuredClone(work);
    Object.assign(work, nothing());
    return done;
  };
}

describe('while the scene goes on', () => {
  let browser, page;
  before(async () => {
    browser = await browsing.launch();
    page = await browsing.openPage(browser, browsing.urlOf(built), SMALL, [countWork, LARGE]);
    if (await page.locator('[aria-label=Pause]').count()) await page.keyboard.press('Space');
    await goToFrame(page, FIRST);
    await page.locator('[aria-label=Frame]').blur();
    assert.ok((await page.evaluate(() => window.takeWork())).floats > 0, 'the counter counts');
  });
  after(() => browser.close());

  /** The work of `count` steps, after the first ones. */
  async function workOfSteps(key) {
    await page.keyboard.press(key);
    await settled();
    await page.evaluate(() => window.takeWork());
    const begin = await number(page, 'frame');
    for (let i = 1; i <= FRAMES; ++i) {
      await page.keyboard.press(key);
      await answered(page, begin + i);
      await settled();
    }
    return page.evaluate(() => window.takeWork());
  }

  /** Waits until the requested frame is drawn. */
  const settled = () =>
    page.evaluate(
      () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))),
    );

  test('each frame is asked once, and drawn once from the arrays that the worker made', async () => {
    const { sent, uploads, draws, floats } = await workOfSteps('ArrowRight');
    assert.equal(sent.pose, FRAMES);
    for (const kind of Object.keys(sent)) assert.match(kind, /^(pose|measure)$/);
    assert.equal(uploads, 4 * FRAMES, 'positions and normals of two');
    assert.equal(draws, 4 * FRAMES, 'two, and their shadows');
    assert.ok(floats < 100 * FRAMES, `${floats} numbers in arrays of the main thread's own`);
  });

  test('only what tells of a frame is written anew', async () => {
    const { changed } = await workOfSteps('ArrowRight');
    const others = changed.filter((place) => !['time', 'contacts', 'work'].includes(place));
    assert.deepEqual(others, []);
    assert.ok(changed.includes('time'));
  });
});
