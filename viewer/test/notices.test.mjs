// The page carries the licences of what is compiled into it.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';

test('the page has the notices of all that is in it', () => {
  const page = readFileSync(process.env.PELT_PAGE ?? 'dist/index.html', 'utf8');
  const [, notices] = page.match(/<script type="text\/plain" id="licences">([^]*?)<\/script>/);
  const { dependencies } = JSON.parse(readFileSync('package.json', 'utf8'));
  for (const name of [...Object.keys(dependencies), 'Pelt', 'Emscripten', 'musl', 'libc++']) {
    assert.ok(notices.includes(`\n${name}`), name);
  }
  for (const holder of ['three.js authors', 'Jason Miller', 'Arseny Kapoulkine', 'Niels Lohmann']) {
    assert.match(notices, new RegExp(`Copyright .*${holder}`));
  }
});
