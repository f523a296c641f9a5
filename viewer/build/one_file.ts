/** A Vite plugin: the page becomes one file that opens from disk and fetches nothing. */

import type { Plugin } from 'vite';

/** Content security policy: the page runs only its own code and its worker, and loads nothing. */
const POLICY = [
  "default-src 'none'",
  "script-src 'unsafe-inline' 'wasm-unsafe-eval' blob:",
  'worker-src blob: data:',
  "style-src 'unsafe-inline'",
  'img-src data: blob:',
  'connect-src data: blob:',
].join('; ');

/** `notices` is text that the page carries along. */
export function oneFile(notices: string): Plugin {
  return {
    name: 'one-file',
    enforce: 'post',
    generateBundle(_, bundle) {
      const page = bundle['index.html'];
      if (page?.type !== 'asset') throw new Error('the build has no index.html');
      let html = String(page.source);
      for (const [name, file] of Object.entries(bundle)) {
        if (file === page) continue;
        html = file.type === 'chunk' ? withScript(html, file.code) : withStyle(html, file.source);
        delete bundle[name];
      }
      const policy = `<meta http-equiv="Content-Security-Policy" content="${POLICY}" />`;
      page.source = withNotices(html, notices).replace(
        '<meta charset="utf-8" />',
        (charset) => `${charset}\n    ${policy}`,
      );
    },
  };
}

/** Adds the script at the end of the page, because scripts run at once. */
function withScript(html: string, code: string): string {
  const safe = code.replaceAll('</script', '<\\/script');
  return html
    .replace(/\s*<script type="module"[^>]*><\/script>/, '')
    .replace('</body>', () => `<script type="module">${safe}</script>\n  </body>`);
}

function withStyle(html: string, source: string | Uint8Array): string {
  return html.replace(/<link rel="stylesheet"[^>]*>/, () => `<style>${String(source)}</style>`);
}

/** Readable in the source; no browser shows or runs it. */
function withNotices(html: string, notices: string): string {
  const element = `<script type="text/plain" id="licences">\n${notices}</script>`;
  return html.replace('</body>', () => `${element}\n  </body>`);
}
