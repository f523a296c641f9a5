/** The package as npm packs and installs it: its files, its README's program, its types. */

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import fs from 'node:fs';
import { createRequire } from 'node:module';
import os from 'node:os';
import path from 'node:path';
import test from 'node:test';
import { fileURLToPath } from 'node:url';
import { kPackage } from './support.mjs';

const kHere = path.dirname(fileURLToPath(import.meta.url));

function run(folder, program, ...args) {
  const ended = spawnSync(program, args, { cwd: folder, encoding: 'utf8' });
  if (ended.error) throw ended.error;
  assert.equal(ended.status, 0, `${program} ${args.join(' ')}:\n${ended.stdout}${ended.stderr}`);
  return ended.stdout;
}

/** A user's folder in which npm has installed the package. */
const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'pelt-user-'));
test.after(() => fs.rmSync(folder, { recursive: true }));
const [packed] = JSON.parse(run(kPackage, 'npm', 'pack', '--json', '--pack-destination', folder));
fs.writeFileSync(path.join(folder, 'package.json'), '{ "type": "module", "private": true }');
run(
  folder,
  'npm',
  'install',
  '--offline',
  '--no-audit',
  '--no-fund',
  path.join(folder, packed.filename),
);
const installed = path.join(folder, 'node_modules', packed.name);

const read = (name) => fs.readFileSync(path.join(installed, name), 'utf8');

function block(language, text = read('README.md')) {
  return text.match(new RegExp(`^\`\`\`${language}\n(.*?)^\`\`\``, 'ms'))[1];
}

test('it has what it needs, the licences, and nothing else', () => {
  const files = packed.files
    .map((file) => file.path)
    .filter((name) => !/^(lib|types)\//.test(name));
  const others = ['LICENSE', 'README.md', 'THIRD-PARTY-NOTICES', 'package.json', 'pelt.d.ts'];
  assert.deepEqual(files.sort(), [...others, 'engine.mjs', 'pelt.mjs'].sort());
  assert.deepEqual(
    fs.readdirSync(path.join(folder, 'node_modules')).filter((name) => name[0] !== '.'),
    [packed.name],
  );
});

test('its version is that of the engine', async () => {
  const { loadPelt } = await import(path.join(installed, 'pelt.mjs'));
  assert.equal(packed.version, (await loadPelt()).version);
});

test('where there is no SIMD it says so in words', async (t) => {
  const { loadPelt } = await import(path.join(installed, 'pelt.mjs'));
  t.mock.method(WebAssembly, 'validate', () => false);
  await assert.rejects(loadPelt(), { code: 'unsupported', message: /WebAssembly with SIMD/ });
});

test('only what is documented can be imported', () => {
  const from = createRequire(path.join(folder, 'program.cjs'));
  for (const inside of ['lib/memory.mjs', 'engine.mjs']) {
    assert.throws(() => from.resolve(`${packed.name}/${inside}`), {
      code: 'ERR_PACKAGE_PATH_NOT_EXPORTED',
    });
  }
});

test('the licences of all that is compiled in come with it', () => {
  const notices = read('THIRD-PARTY-NOTICES');
  for (const words of [
    /JSON for Modern C\+\+[^]*Niels Lohmann/,
    /Emscripten[^]*The Emscripten Authors/,
    /musl[^]*Rich Felker/,
    /LLVM[^]*Apache License[^]*LLVM Exceptions/,
    /Permission is hereby granted, free of charge/,
  ]) {
    assert.match(notices, words);
  }
});

test("the README's program prints what the README says", () => {
  fs.writeFileSync(path.join(folder, 'program.mjs'), block('js'));
  assert.equal(run(folder, process.execPath, 'program.mjs'), block('text'));
});

test('the program of docs/getting-started.md finds contacts', () => {
  const page = fs.readFileSync(path.join(kHere, '../../docs/getting-started.md'), 'utf8');
  fs.writeFileSync(path.join(folder, 'short.mjs'), block('js', page));
  assert.match(run(folder, process.execPath, 'short.mjs'), /^[1-9]\d*\n$/);
});

const kTypeScript = path.join(kHere, '../../viewer/node_modules/typescript/lib/typescript.js');
const skip = !fs.existsSync(kTypeScript) && 'TypeScript is not installed: run npm ci in viewer';
const typescript = () => createRequire(import.meta.url)(kTypeScript);

const kProgram = path.join(kHere, 'types');

function compile(...options) {
  const compiler = path.join(path.dirname(kTypeScript), 'tsc.js');
  return run(folder, process.execPath, compiler, '--project', 'tsconfig.json', ...options);
}

test('a program that uses all types compiles and runs', { skip }, () => {
  fs.cpSync(kProgram, folder, { recursive: true });
  compile();
  run(folder, process.execPath, 'out/consumer.js');
  compile('--module', 'ESNext', '--moduleResolution', 'Bundler', '--noEmit');
});

/** The names that pelt.d.ts and its types export, and those of their members. */
function declared() {
  const ts = typescript();
  const inner = fs.readdirSync(path.join(installed, 'types')).map((name) => `types/${name}`);
  const statements = ['pelt.d.ts', ...inner].flatMap((name) => [
    ...ts.createSourceFile(name, read(name), ts.ScriptTarget.ES2022, true).statements,
  ]);
  const types = new Map();
  for (const statement of statements) {
    if (ts.isImportDeclaration(statement) || ts.isExportDeclaration(statement)) continue;
    const name = statement.name?.text ?? statement.declarationList.declarations[0].name.text;
    const members =
      statement.members ?? statement.declarationList?.declarations[0].type.members ?? [];
    types.set(name, members.map((member) => member.name?.text).filter(Boolean));
  }
  return types;
}

test('that program uses all that is declared', { skip }, () => {
  const files = ['consumer.ts', 'queries.ts'].map((name) => path.join(kProgram, name));
  const words = new Set(files.flatMap((file) => fs.readFileSync(file, 'utf8').match(/\w+/g)));
  const types = declared();
  assert.ok(types.size > 30 && types.get('Pose').includes('setPalette'));
  for (const [name, members] of types) {
    for (const word of [name, ...members])
      assert.ok(words.has(word), `${name}: ${word} is not used`);
  }
});

/** Names of an object and of its class, as a user sees them. */
function namesOf(object) {
  const names = [
    ...Object.keys(object),
    ...Object.getOwnPropertyNames(Object.getPrototypeOf(object)),
  ];
  return names.filter((name) => name !== 'constructor').sort();
}

test('objects have the members that are declared, and no others', { skip }, async () => {
  const { loadPelt } = await import(path.join(installed, 'pelt.mjs'));
  const pelt = await loadPelt();
  const character = pelt.generateCreature({ triangles: 1000, joints: 20 });
  const objects = {
    Pelt: pelt,
    Character: character,
    Pose: character.makePose(),
    Scene: pelt.makeScene({ characters: [character], instances: [] }),
    Crowd: pelt.makeCrowd(),
    ContactHash: pelt.makeContactHash(),
    ContactTally: pelt.makeContactTally(),
    SelfFilter: character.makeSelfFilter(),
  };
  const types = declared();
  for (const [name, object] of Object.entries(objects)) {
    assert.deepEqual(namesOf(object), [...types.get(name)].sort(), name);
  }
});
