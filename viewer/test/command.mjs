// The command's answer for a scene, for comparison with the page's.

import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';

export const command = process.env.PELT_COMMAND;

/** A folder for the length of a test. */
export function temporaryFolder(test) {
  const folder = mkdtempSync(path.join(tmpdir(), 'pelt-viewer-'));
  test.after(() => rmSync(folder, { recursive: true }));
  return folder;
}

/** Output of the command. */
function run(words, folder = '.') {
  const { status, stdout, stderr } = spawnSync(path.resolve(command), words, {
    cwd: folder,
    encoding: 'utf8',
    maxBuffer: 2 ** 28,
  });
  if (status !== 0 && status !== 1) throw new Error(`pelt ${words.join(' ')}: ${stderr}`);
  return stdout;
}

/** The frames' numbers of contacts, the work and the hash; `files` lie beside the scene, by their names. */
export function check(test, scene, files = {}, options = []) {
  const text = Buffer.from(JSON.stringify(scene));
  return checkFiles(test, { ...files, 'scene.json': text }, ['scene.json', ...options]);
}

/** The same for `pelt check WORDS...` in a folder with files. */
export function checkFiles(test, files, words) {
  const folder = temporaryFolder(test);
  for (const [name, bytes] of Object.entries(files)) writeFileSync(path.join(folder, name), bytes);
  const lines = run(['check', ...words, '--jsonl', '-'], folder)
    .trim()
    .split('\n')
    .map((line) => JSON.parse(line));
  const { totals, counters, hash } = lines.at(-1);
  const counts = lines.slice(1, -1).map(({ contacts }) => contacts);
  return { counts, totals, counters, hash };
}

/** A .glb file: a generated character, posed. */
export function posedWalker(test) {
  const folder = temporaryFolder(test);
  const scene = {
    models: { small: { creature: { triangles: 1664, joints: 45, seed: 3 } } },
    instances: [{ model: 'small', clip: 'walk' }],
  };
  writeFileSync(path.join(folder, 'scene.json'), JSON.stringify(scene));
  run([
    'pose',
    path.join(folder, 'scene.json'),
    '--frame',
    '0',
    '-o',
    path.join(folder, 'walker.glb'),
  ]);
  return readFileSync(path.join(folder, 'walker.glb'));
}
