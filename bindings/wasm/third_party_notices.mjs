/**
 * third_party_notices.mjs EMSCRIPTEN OUTPUT: writes the licence notices of what is compiled into
 * engine.mjs, as the installed sources have them. EMSCRIPTEN is the folder of emcc.
 */

import fs from 'node:fs';
import path from 'node:path';

const [emscripten, output] = process.argv.slice(2);
const kLicences = '/usr/share/common-licenses';

function read(file, whose) {
  if (fs.existsSync(file)) return fs.readFileSync(file, 'utf8');
  console.error(
    `${file}, which has the notice of ${whose}, is not there: the package must not go without`,
  );
  process.exit(1);
}

/** Returns the paragraphs of a Debian copyright file as Maps of fields. */
function copyrightFile(name) {
  const text = read(`/usr/share/doc/${name}/copyright`, name);
  return text.split(/\n\n+/).map((paragraph) => {
    const fields = paragraph
      .split(/\n(?=[A-Z])/)
      .map((field) => /^([\w-]+):\s*([^]*)$/.exec(field));
    return new Map(fields.filter(Boolean).map(([, key, value]) => [key, unquoted(value)]));
  });
}

/** Removes the indentation; a line with a dot is an empty line. */
function unquoted(value) {
  return value.replace(/^ \.$/gm, '').replace(/^ /gm, '').trim();
}

/** Returns the copyright holders of the files that match these patterns. */
function holders(paragraphs, ...patterns) {
  const isAsked = (paragraph) => patterns.includes(paragraph.get('Files'));
  const found = paragraphs.filter(isAsked);
  if (found.length !== patterns.length) throw new Error(`${patterns}: some are not named`);
  const lines = found.flatMap((paragraph) => paragraph.get('Copyright').split('\n'));
  return [...new Set(lines.map((line) => line.trim()))]
    .map((line) => `Copyright ${line}`)
    .join('\n');
}

/** Returns the text of a licence, which the file contains once. */
function licence(paragraphs, name) {
  const isAsked = (paragraph) =>
    !paragraph.has('Files') && paragraph.get('License')?.startsWith(`${name}\n`);
  return paragraphs.find(isAsked).get('License').slice(name.length).trim();
}

function jsonNotice() {
  const paragraphs = copyrightFile('nlohmann-json3-dev');
  const files = [
    '*',
    'include/nlohmann/detail/conversions/to_chars.hpp',
    'include/nlohmann/detail/output/serializer.hpp',
  ];
  return `${holders(paragraphs, ...files)}\n\n${licence(paragraphs, 'Expat')}`;
}

function emscriptenNotice(paragraphs) {
  return `${holders(paragraphs, '*')}\n\n${licence(paragraphs, 'Expat')}`;
}

function llvmNotice(paragraphs) {
  const files = ['system/lib/libcxx/*', 'system/lib/libcxxabi/*', 'system/lib/compiler-rt/*'];
  const given = paragraphs.find((paragraph) => paragraph.get('Files') === files[0]).get('License');
  const exception = given.slice(given.indexOf('\n') + 1);
  const apache = read(path.join(kLicences, 'Apache-2.0'), 'libc++').trimEnd();
  const title = '---- LLVM Exceptions to the Apache License ----';
  return [holders(paragraphs, ...files), apache, title, exception].join('\n\n');
}

function muslNotice() {
  return read(path.join(emscripten, 'system/lib/libc/musl/COPYRIGHT'), 'musl').trim();
}

const paragraphs = copyrightFile('emscripten');
const notices = [
  ['JSON for Modern C++ (github.com/nlohmann/json), MIT licence', jsonNotice()],
  ['Emscripten (emscripten.org), MIT licence', emscriptenNotice(paragraphs)],
  ['musl (musl.libc.org), MIT licence', muslNotice()],
  [
    'libc++, libc++abi and compiler-rt (llvm.org), Apache License 2.0 with LLVM Exceptions',
    llvmNotice(paragraphs),
  ],
];
const line = '='.repeat(80);
const sections = notices.map(([name, text]) => `${line}\n${name}\n${line}\n\n${text}\n`);
const head = 'engine.mjs has in it, in compiled form, parts of the following.\n';
fs.writeFileSync(output, [head, ...sections].join('\n'));
