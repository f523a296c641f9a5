/** Files under the paths by which others name them, though they were dropped without folders. */

import { isCharacter, type NamedFile } from './protocol';

/** The part of a scene file that refers to files. */
interface SceneNames {
  models?: Record<string, unknown>;
}

interface GltfNames {
  buffers?: { uri?: string }[];
}

export interface SceneFiles {
  /** Path of the scene file. */
  path: string;
  files: Map<string, NamedFile['bytes']>;
}

/** The scene and all that it names, in one folder. */
export function filesOfScene(path: string, files: readonly NamedFile[]): SceneFiles {
  const scene = files.find((file) => file.path === path);
  if (!scene) throw new Error(`${path} is not among the files`);
  const models = Object.values((jsonIn(scene.bytes) as SceneNames | null)?.models ?? {});
  const named = models.map(fileIn).filter((name) => name !== null);
  const folder = deepEnough(path, named) + folderOf(path);
  const found = new Map([[folder + nameOf(path), scene.bytes]]);
  for (const name of named) {
    const model = find(files, folderOf(path) + name);
    if (!model) continue; // the engine reports missing models
    const place = joined(folder, name);
    found.set(place, model.bytes);
    for (const [uri, bytes] of buffersOf(model, files))
      found.set(joined(folderOf(place), uri), bytes);
  }
  return { path: folder + nameOf(path), files: found };
}

/** The file of a model, which may be anything: the engine validates the scene. */
function fileIn(model: unknown): string | null {
  if (typeof model === 'string') return model;
  const file = typeof model === 'object' && model !== null && 'file' in model ? model.file : null;
  return typeof file === 'string' ? file : null;
}

/** The files that a .gltf file names, by the names that it gives them. */
export function buffersOf(
  model: NamedFile,
  files: readonly NamedFile[],
): Map<string, NamedFile['bytes']> {
  const found = new Map<string, NamedFile['bytes']>();
  if (!isCharacter(model) || /\.glb$/i.test(model.path)) return found;
  for (const { uri } of (jsonIn(model.bytes) as GltfNames | null)?.buffers ?? []) {
    if (!uri || uri.startsWith('data:')) continue;
    const name = decoded(uri);
    const file = find(files, folderOf(model.path) + name);
    if (file) found.set(name, file.bytes);
  }
  return found;
}

/** The file in that place, or else the only one of that name. */
function find(files: readonly NamedFile[], path: string): NamedFile | undefined {
  const place = joined('', path);
  const inPlace = files.find((file) => joined('', file.path) === place);
  const sameName = files.filter((file) => nameOf(file.path) === nameOf(place));
  return inPlace ?? (sameName.length === 1 ? sameName[0] : undefined);
}

/** Folders from which the names do not lead out. */
function deepEnough(path: string, names: readonly string[]): string {
  const ups = names.map((name) => (folderOf(path) + name).split('/'));
  return 'scene/'.repeat(
    Math.max(0, ...ups.map((parts) => parts.filter((p) => p === '..').length)),
  );
}

/** Resolves "." and ".." within the folder. */
function joined(folder: string, path: string): string {
  const parts: string[] = [];
  for (const part of `${folder}${path}`.split('/')) {
    if (part === '..') parts.pop();
    else if (part !== '' && part !== '.') parts.push(part);
  }
  return parts.join('/');
}

function folderOf(path: string): string {
  return path.slice(0, path.lastIndexOf('/') + 1);
}

function nameOf(path: string): string {
  return path.slice(path.lastIndexOf('/') + 1);
}

function decoded(uri: string): string {
  try {
    return decodeURIComponent(uri);
  } catch {
    return uri;
  }
}

/** Returns nothing for invalid JSON; the engine reports the error. */
function jsonIn(bytes: Uint8Array): unknown {
  try {
    return JSON.parse(new TextDecoder().decode(bytes));
  } catch {
    return null;
  }
}
