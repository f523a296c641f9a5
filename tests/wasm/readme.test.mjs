/** The program in the package's README prints what the README says. */

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';
import test from 'node:test';

const kPackage = process.env.PELT_WASM_PACKAGE;

function block(readme, language) {
  return readme.match(new RegExp(`^\`\`\`${language}\n(.*?)^\`\`\``, 'ms'))[1];
}

test('the README\'s program runs, installed as a package', () => {
  const readme = fs.readFileSync(path.join(kPackage, 'README.md'), 'utf8');
  const { name } = JSON.parse(fs.readFileSync(path.join(kPackage, 'package.json'), 'utf8'));
  const folder = fs.mkdtempSync(path.join(kPackage, 'readme-'));
  try {
    const modules = path.join(folder, 'node_modules');
    fs.mkdirSync(path.join(modules, path.dirname(name)), { recursive: true });
    fs.symlinkSync(kPackage, path.join(modules, name), 'dir');
    fs.writeFileSync(path.join(folder, 'program.mjs'), block(readme, 'js'));
    const ended = spawnSync(process.execPath, ['program.mjs'], { cwd: folder, encoding: 'utf8' });
    assert.equal(ended.stderr, '');
    assert.equal(ended.stdout, block(readme, 'text'));
  } finally {
    fs.rmSync(folder, { recursive: true });
  }
});
