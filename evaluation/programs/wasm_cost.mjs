/**
 * evaluation/programs/wasm_cost.mjs SCENE...: what a frame costs with the npm package and natively, and what
 * skinning everything costs, in microseconds on one thread.
 *
 * As in `pelt bench`, each repetition runs the frame before it, untimed; then the clock runs while
 * palettes are handed over and all pairs asked; the median of the repetitions stands for the frame,
 * and what is printed is the mean over all frames. Prints no time unless both found the same contacts.
 * Scenes may use generated characters and .glb files. PELT_COMMAND and PELT_WASM_PACKAGE name the
 * command and the package, if they are not in build/release and build/wasm/package.
 */

import { spawnSync } from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';

const kRoot = fileURLToPath(new URL('../..', import.meta.url));
const kCommand = process.env.PELT_COMMAND ?? path.join(kRoot, 'build/release/tools/pelt/pelt');
const kPackage = process.env.PELT_WASM_PACKAGE ?? path.join(kRoot, 'build/wasm/package');
const kRepetitions = 9;

const { loadPelt } = await import(pathToFileURL(path.resolve(kPackage, 'pelt.mjs')));
const pelt = await loadPelt();

function readScene(file) {
  const files = { 'scene.json': fs.readFileSync(file) };
  for (const model of Object.values(JSON.parse(files['scene.json']).models)) {
    if (typeof model === 'string')
      files[model] = fs.readFileSync(path.join(path.dirname(file), model));
  }
  return pelt.readScene('scene.json', files);
}

function median(times) {
  return times.sort((a, b) => a - b)[times.length >> 1];
}

function mean(times) {
  return times.reduce((sum, time) => sum + time, 0) / times.length;
}

/** Poses of all instances, with all that is handed over prepared. */
class Run {
  constructor(scene) {
    const character = ({ character }) => scene.characters[character];
    this.poses = scene.instances.map((instance) => character(instance).makePose());
    this.frames = Array.from({ length: scene.frameCount }, (_, frame) =>
      this.poses.map((_, i) => ({
        palette: scene.palette(i, frame),
        weights: scene.morphWeights(i, frame),
      })),
    );
    this.vertices = this.poses.map((pose) => new Float32Array(3 * pose.character.vertexCount));
  }

  pose(frame) {
    this.poses.forEach((pose, i) => {
      const { palette, weights } = this.frames[frame][i];
      if (weights.length > 0) pose.setMorphWeights(weights);
      pose.setPalette(palette);
    });
  }

  /** Calls `found(a, b, pairs)` for every two instances. */
  ask(frame, found = () => {}) {
    this.pose(frame);
    this.poses.forEach((a, i) => {
      for (let j = i + 1; j < this.poses.length; ++j)
        found(i, j, pelt.collide(a, this.poses[j]).pairs);
    });
  }

  skin(frame) {
    this.pose(frame);
    this.poses.forEach((pose, i) => pose.posedVertices(this.vertices[i]));
  }

  /** Microseconds a frame. */
  time(work) {
    const last = this.frames.length - 1;
    const ofFrame = (_, frame) => {
      const times = Array.from({ length: kRepetitions }, () => {
        work(frame > 0 ? frame - 1 : last);
        const begin = performance.now();
        work(frame);
        return 1000 * (performance.now() - begin);
      });
      return median(times);
    };
    return mean(this.frames.map(ofFrame));
  }
}

function measureHere(file) {
  const run = new Run(readScene(file));
  const hash = pelt.makeContactHash();
  run.frames.forEach((_, frame) => run.ask(frame, (a, b, pairs) => hash.add(frame, a, b, pairs)));
  const ask = run.time((frame) => run.ask(frame));
  const skin = run.time((frame) => run.skin(frame));
  return { name: `WebAssembly, Node ${process.version}`, hash: hash.value, ask, skin };
}

/** The times of `pelt bench` with one instruction set; null if the machine does not support it. */
function measureNatively(file, instructionSet) {
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'pelt-'));
  const json = path.join(folder, 'figures.json');
  const asked = ['--methods', 'on_demand', '--queries', 'all', '--simd', instructionSet];
  spawnSync(kCommand, ['bench', file, ...asked, '--repeat', kRepetitions, '--json', json]);
  const figures = fs.existsSync(json) ? JSON.parse(fs.readFileSync(json)).scenes[0] : null;
  fs.rmSync(folder, { recursive: true });
  if (figures === null) return null;
  const [{ hash, mean_us: ask }] = figures.methods;
  return { name: `native, ${instructionSet}`, hash, ask, skin: figures.skinning.mean_us };
}

function print(file) {
  const here = measureHere(file);
  const natively = ['simd128', 'avx2']
    .map((instructionSet) => measureNatively(file, instructionSet))
    .filter(Boolean);
  for (const { name, hash } of natively) {
    if (hash === here.hash) continue;
    console.error(`${file}: ${hash} ${name}, but ${here.hash} here: no times of different answers`);
    process.exit(1);
  }
  console.log(`${path.basename(file)}, ${here.hash}:`);
  for (const { name, ask, skin } of [here, ...natively]) {
    console.log(
      `  ${name.padEnd(28)} frame ${ask.toFixed(1)} us, skinning everything ${skin.toFixed(0)} us`,
    );
  }
}

const files = process.argv.slice(2);
if (files.length === 0) console.log('usage: evaluation/programs/wasm_cost.mjs SCENE...');
files.forEach(print);
