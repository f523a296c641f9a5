// Scenes that need more memory than available, as on a phone: the page reports it and continues.

import assert from 'node:assert/strict';
import path from 'node:path';
import { after, before, test } from 'node:test';
import * as browsing from './browser.mjs';

const built = path.resolve(process.env.PELT_PAGE ?? 'dist/index.html');

/** The walkers fit, and what is dropped does not. */
const MEMORY = 128 << 20;

let browser, page;
before(async () => {
  browser = await browsing.launch();
  const newContext = async (options) => {
    const context = await browser.newContext(options);
    await context.addInitScript(limitWorkers, MEMORY);
    return context;
  };
  page = await browsing.openToCount({ newContext }, browsing.urlOf(built));
});
after(() => browser.close());

/** Runs in the page: programs that it makes workers of get engines that grow no further. */
function limitWorkers(most) {
  const limit = `{
    const { grow } = WebAssembly.Memory.prototype;
    WebAssembly.Memory.prototype.grow = function (pages) {
      if (this.buffer.byteLength + pages * 65536 > ${most}) throw new RangeError('no more');
      return grow.call(this, pages);
    };
  }\n`;
  const make = URL.createObjectURL;
  URL.createObjectURL = (blob) =>
    make(blob.type.includes('javascript') ? new Blob([limit, blob], { type: blob.type }) : blob);
}

/** A small file that declares `vertices` vertices, all zero. */
function zeros(vertices) {
  return Buffer.from(
    JSON.stringify({
      asset: { version: '2.0' },
      scene: 0,
      scenes: [{ nodes: [0] }],
      nodes: [{ mesh: 0 }],
      meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1 }] }],
      accessors: [
        { componentType: 5126, type: 'VEC3', count: vertices },
        { componentType: 5125, type: 'SCALAR', count: 3 },
      ],
      extras: 'x'.repeat(1 << 20),
    }),
  );
}

test('a file that does not fit is refused, and the stage is as it was', async () => {
  const frame = 90;
  await browsing.goToFrame(page, frame);
  const contacts = await browsing.fact(page, 'contacts');
  const total = await browsing.fact(page, 'total');
  for (const name of ['first.gltf', 'second.gltf']) {
    await browsing.dropFiles(page, [{ name, bytes: zeros(4_000_000) }]);
    const problem = page.locator('.problem');
    assert.match(
      await problem.innerText(),
      /ran out of memory and was restarted\. The scene is unchanged\./,
    );
    await problem.getByRole('button', { name: 'Dismiss' }).click();
    await problem.waitFor({ state: 'detached' });
  }
  await browsing.goToFrame(page, 0);
  await browsing.goToFrame(page, frame);
  assert.equal(await browsing.fact(page, 'contacts'), contacts);
  assert.equal(await browsing.fact(page, 'total'), total);
  assert.deepEqual(page.complaints, []);
});
