/** Objects that are forgotten without `delete` are freed by the garbage collector. */

import assert from 'node:assert/strict';
import test from 'node:test';
import v8 from 'node:v8';
import vm from 'node:vm';
import { bytesInUse, pelt } from './support.mjs';

v8.setFlagsFromString('--expose-gc');
const collectGarbage = vm.runInNewContext('gc');
const nextTurn = () => new Promise((resolve) => setTimeout(resolve, 1));

function useAndForget() {
  const face = pelt.generateFace({ triangles: 1000 });
  const [a, b] = [face.makePose(), face.makePose()];
  pelt.collide(a, b);
  pelt.makeSearch(a, b).run(Infinity);
  pelt.selfCollide(a, face.makeSelfFilter());
  const crowd = pelt.makeCrowd();
  crowd.add(face);
  crowd.collide();
  pelt.makeContactHash();
  pelt.makeContactTally().add(pelt.selfCollide(a, face.makeSelfFilter()).pairs);
}

test('characters, poses, filters, searches, crowds and hashes that are forgotten are given back', async () => {
  useAndForget();
  for (let turn = 0; turn < 20; ++turn) {
    collectGarbage();
    await nextTurn();
  }
  const before = bytesInUse();
  for (let i = 0; i < 5; ++i) useAndForget();
  assert.ok(bytesInUse() > before + 200_000, `${bytesInUse() - before} bytes are not enough`);
  for (let turn = 0; turn < 1000 && bytesInUse() > before; ++turn) {
    collectGarbage();
    await nextTurn();
  }
  assert.ok(bytesInUse() - before < 1024, `${bytesInUse() - before} bytes are kept`);
});
