// compare.mjs POSED_CORNERS FILE_OR_FOLDER...: checks that Pelt and three.js pose every model in
// the same way.
//
// POSED_CORNERS is the test program that poses with Pelt. Triangles are matched by their number,
// and their vertices up to rotation, because three.js starts the triangles of strips at another
// vertex.

import { execFileSync } from 'node:child_process';
import { mkdtempSync, readdirSync, readFileSync, rmSync, statSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { loadModel, poseCorners } from './three_pose.mjs';

const TOLERANCE = 1e-4; // relative to the extent of the pose
const MOST_CLIPS = 4;

function modelFiles(argument) {
  if (!statSync(argument).isDirectory()) return [argument];
  const names = readdirSync(argument).filter((name) => /\.(glb|gltf)$/.test(name));
  return names.sort().map((name) => path.join(argument, name));
}

/** The default pose, and a few clips spread over the list, each at a few times. */
function choosePoses(clips) {
  const poses = [{ clip: -1, seconds: 0 }];
  const step = Math.max(1, Math.floor(clips.length / MOST_CLIPS));
  for (let clip = 0; clip < clips.length && clip < step * MOST_CLIPS; clip += step) {
    for (const share of [0, 0.37, 0.81, 1]) {
      poses.push({ clip, seconds: Math.fround(share * clips[clip].duration) });
    }
  }
  return poses;
}

/** Pelt's corners for each pose. */
function askPelt(program, file, poses, folder) {
  const out = path.join(folder, 'corners');
  execFileSync(program, [file, out, ...poses.map(({ clip, seconds }) => `${clip}:${seconds}`)]);
  const bytes = readFileSync(out);
  const all = new Float32Array(bytes.buffer, bytes.byteOffset, bytes.byteLength / 4);
  const size = all.length / poses.length;
  return poses.map((pose, i) => all.subarray(i * size, (i + 1) * size));
}

function extent(corners) {
  let largest = 0;
  for (let axis = 0; axis < 3; ++axis) {
    let low = Infinity;
    let high = -Infinity;
    for (let i = axis; i < corners.length; i += 3) {
      low = Math.min(low, corners[i]);
      high = Math.max(high, corners[i]);
    }
    largest = Math.max(largest, high - low);
  }
  return largest;
}

/** The largest difference of a coordinate of triangle `t`, the triangle turned by `turn` corners. */
function triangleError(ours, theirs, t, turn) {
  let error = 0;
  for (let i = 0; i < 9; ++i) {
    const difference = Math.abs(ours[9 * t + i] - theirs[9 * t + ((i + 3 * turn) % 9)]);
    if (!(difference <= error)) error = difference;
  }
  return error;
}

function largestError(ours, theirs) {
  let error = 0;
  for (let t = 0; t < ours.length / 9; ++t) {
    const errors = [0, 1, 2].map((turn) => triangleError(ours, theirs, t, turn));
    error = Math.max(error, Math.min(...errors));
  }
  return error;
}

async function compareModel(program, file, folder) {
  const model = await loadModel(file);
  const poses = choosePoses(model.clips);
  const ours = askPelt(program, file, poses, folder);
  let worst = 0;
  poses.forEach(({ clip, seconds }, i) => {
    const theirs = poseCorners(model, model.clips[clip] ?? null, seconds);
    const where = `${path.basename(file)}, clip ${clip} at ${seconds} s`;
    if (ours[i].length !== theirs.length) {
      throw new Error(`${where}: ${ours[i].length / 9} triangles, three.js has ${theirs.length / 9}`);
    }
    const error = largestError(ours[i], theirs) / extent(theirs);
    if (!(error <= TOLERANCE)) throw new Error(`${where}: off by ${error} of the extent`);
    worst = Math.max(worst, error);
  });
  const triangles = ours[0].length / 9;
  console.log(`${path.basename(file)}: ${poses.length} poses of ${triangles} triangles, ` +
    `off by at most ${worst.toExponential(1)} of the extent`);
}

const [program, ...rest] = process.argv.slice(2);
const files = rest.flatMap(modelFiles);
if (files.length === 0) throw new Error('no models to compare');
const folder = mkdtempSync(path.join(tmpdir(), 'pelt-three-'));
try {
  for (const file of files) await compareModel(program, file, folder);
} finally {
  rmSync(folder, { recursive: true });
}
