// Loads parts of the page in Node: `load('scene/scene.ts')` returns the module; `root` is the folder
// of package.json.

import { fileURLToPath } from 'node:url';
import { createServer } from 'vite';

export const root = fileURLToPath(new URL('..', import.meta.url));
let vite;

export const load = (file) => vite.ssrLoadModule(`/src/${file}`);

export async function openSources() {
  globalThis.matchMedia = () => ({ matches: false, addEventListener: () => {} });
  vite = await createServer({
    root,
    configFile: false,
    appType: 'custom',
    logLevel: 'error',
    server: { middlewareMode: true, hmr: false, ws: false, watch: null },
    optimizeDeps: { noDiscovery: true },
    esbuild: { jsx: 'automatic', jsxImportSource: 'preact' },
  });
}

export const closeSources = () => vite.close();
