/** The licence notices of all that is compiled into the page, as the packages bring them. */

import { existsSync, readFileSync } from 'node:fs';

const LINE = '='.repeat(80);

/** `viewer` and `engine` are folders: of this package, and of the one that bindings/wasm builds. */
export function notices(viewer: string, engine: string): string {
  const { dependencies } = JSON.parse(readFileSync(`${viewer}/package.json`, 'utf8'));
  const libraries = Object.keys(dependencies).map((name) => section(name, licenceOf(viewer, name)));
  const pelt = section('Pelt', read(`${engine}/LICENSE`));
  return [pelt, ...libraries, read(`${engine}/THIRD-PARTY-NOTICES`)].join('\n');
}

function read(file: string): string {
  return readFileSync(file, 'utf8').trim() + '\n';
}

function section(name: string, text: string): string {
  return `${LINE}\n${name}\n${LINE}\n\n${text}`;
}

function licenceOf(viewer: string, name: string): string {
  const files = ['LICENSE', 'LICENSE.md'].map((file) => `${viewer}/node_modules/${name}/${file}`);
  const file = files.find((file) => existsSync(file));
  if (file === undefined)
    throw new Error(`${name} has no licence file: the page must not go without`);
  return read(file);
}
