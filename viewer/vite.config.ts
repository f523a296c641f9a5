import { defineConfig } from 'vite';
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { notices } from './build/notices';
import { oneFile } from './build/one_file';

const here = fileURLToPath(new URL('.', import.meta.url));

/** The package that bindings/wasm builds; elsewhere if PELT_WASM says so. */
const folder =
  process.env.PELT_WASM ?? fileURLToPath(new URL('../build/wasm/package', import.meta.url));
const engine = `${folder}/pelt.mjs`;

/** The version that the page shows; the command looks for it. */
process.env.VITE_PELT_VERSION = JSON.parse(readFileSync(`${folder}/package.json`, 'utf8')).version;

export default defineConfig({
  resolve: { alias: { pelt: engine } },
  base: './',
  esbuild: { jsx: 'automatic', jsxImportSource: 'preact', legalComments: 'inline' },
  build: {
    target: 'es2022',
    modulePreload: false,
    cssCodeSplit: false,
    chunkSizeWarningLimit: 8000,
  },
  plugins: [oneFile(notices(here, folder))],
});
