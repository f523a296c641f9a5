/** Files and folders dropped anywhere on the page, or chosen in a dialog. */

import { refuse } from '../state/changes';
import type { Update } from '../state/state';

export interface DroppedFile {
  /** Relative to the dropped folder. */
  path: string;
  file: File;
}

type Open = (files: DroppedFile[]) => void;

/** With Shift held, dropped files are added to the scene. */
export function watchDrops(update: Update, open: Open, add: Open): void {
  document.addEventListener('dragover', (event) => {
    if (!event.dataTransfer?.types.includes('Files')) return;
    event.preventDefault();
    update(({ isDropping }) => (isDropping ? {} : { isDropping: true }));
  });
  document.addEventListener('dragleave', ({ relatedTarget }) => {
    if (relatedTarget === null) update(() => ({ isDropping: false }));
  });
  document.addEventListener('drop', (event) => {
    event.preventDefault();
    update(() => ({ isDropping: false }));
    const take = event.shiftKey ? add : open;
    if (event.dataTransfer?.files.length) void openDropped(event.dataTransfer, update, take);
  });
}

export function chooseFiles(open: Open): void {
  const input = document.createElement('input');
  Object.assign(input, { type: 'file', multiple: true, accept: '.glb,.gltf,.bin,.json' });
  input.addEventListener('change', () => open([...(input.files ?? [])].map(alone)));
  input.click();
}

async function openDropped(dropped: DataTransfer, update: Update, open: Open): Promise<void> {
  try {
    open(await droppedFiles(dropped));
  } catch (error) {
    update(refuse('Cannot read the dropped files', (error as Error).message));
  }
}

/** Includes files of folders. Dropped entries must be read synchronously, before any await. */
async function droppedFiles({ items, files }: DataTransfer): Promise<DroppedFile[]> {
  const dropped = [...items].filter(({ kind }) => kind === 'file');
  const entries = dropped.map((item) => item.webkitGetAsEntry());
  if (entries.some((entry) => entry === null)) return [...files].map(alone);
  return (await Promise.all(entries.map((entry) => filesIn(entry!)))).flat();
}

function alone(file: File): DroppedFile {
  return { path: file.name, file };
}

async function filesIn(entry: FileSystemEntry, folder = ''): Promise<DroppedFile[]> {
  const path = folder + entry.name;
  if (isFile(entry)) return [{ path, file: await fileOf(entry) }];
  const inside = await entriesIn(entry as FileSystemDirectoryEntry);
  return (await Promise.all(inside.map((one) => filesIn(one, `${path}/`)))).flat();
}

function isFile(entry: FileSystemEntry): entry is FileSystemFileEntry {
  return entry.isFile;
}

function fileOf(entry: FileSystemFileEntry): Promise<File> {
  return new Promise((resolve, reject) => entry.file(resolve, reject));
}

/** Browsers give a folder's entries in batches, the last of them empty. */
async function entriesIn(folder: FileSystemDirectoryEntry): Promise<FileSystemEntry[]> {
  const reader = folder.createReader();
  const all: FileSystemEntry[] = [];
  for (;;) {
    const batch = await new Promise<FileSystemEntry[]>((resolve, reject) => {
      reader.readEntries(resolve, reject);
    });
    if (batch.length === 0) return all;
    all.push(...batch);
  }
}
