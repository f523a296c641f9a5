/** Files dropped anywhere on the page, or chosen in a dialog. */

import type { Update } from '../state/state';

export function watchDrops(update: Update, open: (files: File[]) => void): void {
  document.addEventListener('dragover', (event) => {
    event.preventDefault();
    update(() => ({ isDropping: true }));
  });
  document.addEventListener('dragleave', ({ relatedTarget }) => {
    if (relatedTarget === null) update(() => ({ isDropping: false }));
  });
  document.addEventListener('drop', (event) => {
    event.preventDefault();
    update(() => ({ isDropping: false }));
    const files = [...(event.dataTransfer?.files ?? [])];
    if (files.length > 0) open(files);
  });
}

export function chooseFiles(open: (files: File[]) => void): void {
  const input = document.createElement('input');
  Object.assign(input, { type: 'file', multiple: true, accept: '.glb,.gltf,.bin,.json' });
  input.addEventListener('change', () => open([...(input.files ?? [])]));
  input.click();
}
