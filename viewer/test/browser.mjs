// Chromium with the page, from disk or over HTTP, and helpers for tests.

import { readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { pathToFileURL } from 'node:url';
import { chromium } from 'playwright-core';

const ARGUMENTS = ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'];

/** Long enough for the slowest machine to generate two characters. */
export const PATIENCE = 60_000;

export function launch() {
  const executablePath = process.env.PELT_CHROMIUM ?? '/usr/bin/chromium';
  return chromium.launch({ executablePath, args: ARGUMENTS });
}

/** Serves one file at every address; `close()` ends it. */
export async function serve(file) {
  const html = readFileSync(file);
  const server = createServer((_, response) => {
    response.writeHead(200, { 'content-type': 'text/html; charset=utf-8' }).end(html);
  });
  await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
  return { url: `http://127.0.0.1:${server.address().port}/`, close: () => server.close() };
}

export const urlOf = (file) => pathToFileURL(file).href;

/** Opens the page and waits until it has counted the contacts of every frame; `prepare`, a
 * function and its argument, runs in it before all else. Complaints with the word `expected` do
 * not count. */
export async function openPage(browser, url, options = {}, prepare = [], expected = null) {
  const context = await browser.newContext({
    viewport: { width: 960, height: 600 },
    deviceScaleFactor: 0.5, // the processor draws
    colorScheme: 'dark',
    ...options,
  });
  const page = await context.newPage();
  page.setDefaultTimeout(PATIENCE);
  await page.addInitScript(blurCoarsely);
  if (prepare.length > 0) await page.addInitScript(...prepare);
  page.complaints = [];
  page.fetched = [];
  const isExpected = (text) => expected !== null && text.includes(expected);
  const complain = (text) => isExpected(text) || page.complaints.push(text);
  page.on('pageerror', (error) => complain(error.message));
  page.on('console', (line) => line.type() === 'error' && complain(line.text()));
  page.on('request', (request) => page.fetched.push(request.url()));
  await page.goto(url);
  await counted(page);
  return page;
}

/** Runs in the page: three.js blurs the surroundings that surfaces reflect with 4 samples for each
 * pixel instead of up to 256, because the processor draws. No test looks at reflections. */
export function blurCoarsely() {
  const { shaderSource } = WebGL2RenderingContext.prototype;
  WebGL2RenderingContext.prototype.shaderSource = function (shader, source) {
    const coarse = source.replace(/#define (GGX_)?SAMPLES \d+/, '#define $1SAMPLES 4');
    return shaderSource.call(this, shader, coarse);
  };
}

/** Runs in the page: makes it one without a picture. */
export function hideWebGL() {
  const { getContext } = HTMLCanvasElement.prototype;
  HTMLCanvasElement.prototype.getContext = function (kind, ...options) {
    return kind.startsWith('webgl') ? null : getContext.call(this, kind, ...options);
  };
}

/** The same without a picture, which takes most of the time: for tests that count and read. */
export function openToCount(browser, url) {
  return openPage(browser, url, { reducedMotion: 'reduce' }, [hideWebGL], 'WebGL');
}

export async function counted(page) {
  await page.waitForSelector('[data-fact=total]');
}

/** The text of `data-fact` on the page. */
export const fact = (page, name) => page.locator(`[data-fact=${name}]`).innerText();

export const number = async (page, name) => Number((await fact(page, name)).replaceAll(',', ''));

/** Stands still at a frame, which the worker has answered. */
export async function goToFrame(page, frame) {
  await page.locator('[aria-label=Frame]').fill(String(frame));
  await answered(page, frame);
}

/** Waits for the worker's answer to the frame in the scene as it is now. */
export async function answered(page, frame) {
  await page.waitForSelector(`[data-answered="${frame}"]`);
}

/** Drops files, [{name, bytes}], on the page. */
export async function dropFiles(page, files, { shiftKey = false } = {}) {
  const sent = files.map(({ name, bytes }) => ({ name, base64: bytes.toString('base64') }));
  const drop = ({ sent: dropped, shiftKey: isShifted }) => {
    const dataTransfer = new DataTransfer();
    for (const { name, base64 } of dropped) {
      const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
      dataTransfer.items.add(new File([bytes], name));
    }
    const how = { dataTransfer, cancelable: true, shiftKey: isShifted };
    document.dispatchEvent(new DragEvent('drop', how));
  };
  await page.evaluate(drop, { sent, shiftKey });
}

/** Waits until the worst frames have been photographed and the camera has moved to them. */
export async function photographed(page) {
  await page.getByRole('button', { name: 'whole clip' }).click();
  await page.waitForSelector('.stills img');
  await page.waitForTimeout(600);
}

/** The scene as the page saves it. */
export async function savedScene(page) {
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    page.click('text=Save scene'),
  ]);
  return JSON.parse(readFileSync(await download.path(), 'utf8'));
}

/** Least and most red, green and blue. */
export const GLOWING = { least: [220, 60, 0], most: [255, 150, 90] };
export const VIOLET = { least: [170, 30, 200], most: [215, 110, 255] };
export const BLUE = { least: [20, 80, 190], most: [90, 150, 255] };
export const RED = { least: [90, 20, 20], most: [255, 90, 90] };
export const RED_HANDLE = { least: [209, 64, 75], most: [219, 74, 85] };

/**
 * Counts the pixels of the picture with such a colour. Also returns the middle of these pixels on
 * the page, and the number of different colours in the picture, which is one for a black page.
 */
export async function pixels(page, wanted = GLOWING, picture = page.locator('#view')) {
  const bytes = await picture.screenshot();
  const found = await page.evaluate(countPixels, { base64: bytes.toString('base64'), wanted });
  const { x, y, width } = await picture.boundingBox();
  const size = width / found.width; // of a drawn pixel
  return {
    colours: found.colours,
    count: found.count * size ** 2,
    x: x + found.x * size,
    y: y + found.y * size,
  };
}

/** Runs in the page. */
async function countPixels({ base64, wanted: { least, most } }) {
  const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
  const bitmap = await createImageBitmap(new Blob([bytes], { type: 'image/png' }));
  const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d');
  context.drawImage(bitmap, 0, 0);
  const { data } = context.getImageData(0, 0, bitmap.width, bitmap.height);
  const colours = new Set();
  let [count, x, y] = [0, 0, 0];
  for (let pixel = 0; pixel < data.length / 4; ++pixel) {
    const colour = data.subarray(4 * pixel, 4 * pixel + 3);
    colours.add(colour.join());
    if (!colour.every((value, i) => value >= least[i] && value <= most[i])) continue;
    ++count;
    x += pixel % bitmap.width;
    y += Math.floor(pixel / bitmap.width);
  }
  return { count, x: x / count, y: y / count, colours: colours.size, width: bitmap.width };
}

/** Drags the gizmo of the selected character by its handle along x. */
export async function dragGizmo(page) {
  const { x, y } = await pixels(page, RED_HANDLE);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 12, y + 6, { steps: 3 });
  await page.mouse.up();
}

/** The name of what has the focus, and how that is shown. */
export function focused(page) {
  return page.evaluate(() => {
    const control = document.activeElement;
    const name = control.ariaLabel ?? control.innerText;
    return `${name}: ${getComputedStyle(control).outlineStyle}`;
  });
}
