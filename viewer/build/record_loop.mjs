// record_loop.mjs PAGE FOLDER: drives Chromium through the scene that the page opens with, two
// generated characters that walk into each other, and writes one picture for each frame of the loop to
// FOLDER. scripts/record-loop calls it.

import path from 'node:path';
import { answered, counted, goToFrame, launch, photographed, urlOf } from '../test/browser.mjs';

const [file, folder] = process.argv.slice(2);

/** Two characters come from both sides, meet, and leave each other. */
const [FIRST, LAST] = [26, 150];
/** Number of frames in which the picture appears and disappears, because the ends differ. */
const FADE = 8;

const SIZE = { width: 880, height: 460 };
/** Leaves the picture and the counted contacts. */
const STYLE = `
  .head, .side, .picture-bar { opacity: 0 }
  .transport { display: none }
  .time { grid-template-columns: 1fr auto }
  :focus-visible, .chart:has(:focus-visible) { outline: none }
  #view { inset: 0 0 var(--foot) 0 }`;
/** Keys that move the camera beside the way of the characters, and near. */
const KEYS = [...'dddddddd+++'];

/** Waits until the page has drawn. */
const drawn = (page) =>
  page.evaluate(
    () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))),
  );

const browser = await launch();
const look = { viewport: SIZE, colorScheme: 'dark', reducedMotion: 'reduce' };
const page = await (await browser.newContext(look)).newPage();
page.setDefaultTimeout(300_000);
await page.goto(urlOf(file));
await counted(page);
await page.addStyleTag({ content: STYLE });
await photographed(page);
await page.waitForTimeout(2000); // the camera has turned to the contacts
await goToFrame(page, FIRST);
await page.locator('[aria-label=Frame]').blur();
for (const key of KEYS) await page.keyboard.press(key);

for (let frame = FIRST; frame <= LAST; ++frame) {
  const opacity = Math.min(1, (frame - FIRST + 1) / FADE, (LAST - frame + 1) / FADE);
  await page.evaluate((value) => (document.getElementById('view').style.opacity = value), opacity);
  await goToFrame(page, frame);
  await answered(page, frame);
  await drawn(page);
  const name = `${String(frame).padStart(4, '0')}.png`;
  await page.screenshot({ path: path.join(folder, name) });
}
await browser.close();
