// Reports as the command writes them, and a scene whose characters have parts.

import { spawnSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { pathToFileURL } from 'node:url';
import { rocks } from '../../tests/wasm/gltf.mjs';

const command = path.resolve(process.env.PELT_COMMAND);
const PLACE = '<script type="application/json" id="pelt-data">';

/** Two heaps of three stones each, which roll into each other. */
export const SCENE = {
  models: { cairn: 'models/cairn.gltf' },
  frames: { count: 12, fps: 12 },
  instances: [
    { model: 'cairn', clip: 'roll' },
    { model: 'cairn', clip: 'roll', start: 0.5, translation: [0.1, 0.15, 0.05] },
  ],
};
export const STONES = Buffer.from(rocks(['base', 'middle', 'top']));

export class Workshop {
  /** A folder with the scene, for the length of a test. */
  constructor(test, scene = SCENE) {
    this.folder = mkdtempSync(path.join(tmpdir(), 'pelt-report-'));
    test.after(() => rmSync(this.folder, { recursive: true }));
    mkdirSync(this.at('models'));
    writeFileSync(this.at('models/cairn.gltf'), STONES);
    this.write(scene);
  }

  write(scene) {
    writeFileSync(this.at('scene.json'), JSON.stringify(scene));
  }

  at(name) {
    return path.join(this.folder, name);
  }

  run(...words) {
    const { status, stderr } = spawnSync(command, words, { cwd: this.folder, encoding: 'utf8' });
    if (status !== 0 && status !== 1) throw new Error(`pelt ${words.join(' ')}: ${stderr}`);
  }

  /** The last line of `pelt check`, whose report is at `report.html`. */
  check(...options) {
    const outputs = ['--jsonl', 'answer.jsonl', '--html', 'report.html'];
    this.run('check', 'scene.json', ...outputs, ...options);
    return JSON.parse(readFileSync(this.at('answer.jsonl'), 'utf8').trim().split('\n').at(-1));
  }

  /** Changes the data of the report. */
  edit(change) {
    const [head, rest] = readFileSync(this.at('report.html'), 'utf8').split(PLACE);
    const end = rest.indexOf('</script>');
    const data = change(rest.slice(0, end)).replaceAll('<', '\\u003c');
    writeFileSync(this.at('report.html'), head + PLACE + data + rest.slice(end));
  }

  /** The address of the page of `pelt view`. */
  view(...words) {
    this.run('view', '--no-browser', '-o', 'view.html', ...words);
    return pathToFileURL(this.at('view.html')).href;
  }
}
