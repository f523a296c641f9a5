/** Opens files as characters of the scene, or reports a readable error. */

import { originalPath, stopsAtFirst, type Report } from '../report/report';
import { framesToCheck, worstFrame } from '../report/verdict';
import * as changes from '../state/changes';
import type { State } from '../state/state';
import type { Store } from '../state/store';
import { isCharacter, type NamedFile, type Opened, type ReadCharacters } from '../worker/protocol';
import type { Client } from './client';
import type { DroppedFile } from './drops';

/** A frame with many contacts. */
const FIRST_FRAME_OF_DEMO = 76;

export class Opener {
  private opening = Promise.resolve();

  constructor(
    private readonly store: Store<State>,
    private readonly client: Client,
  ) {}

  openDemo(): void {
    const ask = () => this.client.ask('openDemo', {});
    this.open('the generated characters', ask, { frame: FIRST_FRAME_OF_DEMO });
  }

  /** Opens a report, paused at its worst frame if it has contacts. */
  openReport(report: Report): void {
    const { scene, title, reading, answer } = report;
    const worst = answer && worstFrame(answer);
    const by = answer?.options.by ?? 'instance';
    this.store.update(() => ({
      report: { ...report, files: {} }, // the worker has them: they may be large
      by,
      firstContact: stopsAtFirst(report),
      listing: answer ? 'clip' : 'frame',
    }));
    this.read(title, async () => {
      const question = { path: scene, files: report.files, options: reading };
      const opened = asReported(await this.client.ask('openReport', question), report);
      const begin = {
        ...(worst && { frame: worst.frame, plays: false }),
        readingOptions: reading,
        gizmo: null, // otherwise a click could lead to a move by accident
        frames: answer && framesToCheck(answer, opened.scene),
      };
      const open = changes.open(opened, begin);
      return (state) => ({ ...open(state), reported: opened.scene });
    });
  }

  /** Characters, or a scene with its characters; on the stage they replace all others. */
  openFiles(files: readonly DroppedFile[]): void {
    this.open(namesOf(files), async () => this.ask(await Promise.all(files.map(readFile))));
  }

  /** Characters beside those on the stage. */
  addFiles(files: readonly DroppedFile[]): void {
    this.read(namesOf(files), async () => changes.add(await this.askToAdd(files)));
  }

  private ask(files: NamedFile[]): Promise<Opened> {
    const scenes = files.filter(isScene);
    if (scenes.length > 1) {
      throw new Error(`There are several scenes: drop only one of ${pathsOf(scenes)}.`);
    }
    const [scene] = scenes;
    if (scene) return this.client.ask('openScene', { path: scene.path, files, options: {} });
    if (files.some(isCharacter)) return this.client.ask('readCharacters', { files });
    throw new Error('There is no character: drop .glb files, or a scene.json with its files.');
  }

  private async askToAdd(dropped: readonly DroppedFile[]): Promise<ReadCharacters> {
    const files = await Promise.all(dropped.map(readFile));
    if (!files.some(isCharacter)) {
      throw new Error(
        'Only characters can be added: .glb files, or .gltf files with their buffers.',
      );
    }
    const options = this.store.state.readingOptions;
    return this.client.ask('addCharacters', { files, options });
  }

  private open(
    what: string,
    ask: () => Promise<Opened>,
    beginning: Partial<changes.Beginning> = {},
  ): void {
    this.read(what, async () => changes.open(await ask(), beginning));
  }

  /** Reads one selection after the other. The scene is unchanged until everything is read. */
  private read(what: string, ask: () => Promise<changes.Change>): void {
    this.opening = this.opening.then(async () => {
      this.store.update(() => ({ reading: what }));
      try {
        this.store.update(await ask());
      } catch (error) {
        this.store.update(() => ({ reading: null }));
        this.store.update(changes.refuse(`${what} could not be opened`, (error as Error).message));
      }
    });
  }
}

async function readFile({ path, file }: DroppedFile): Promise<NamedFile> {
  return { path, bytes: new Uint8Array(await file.arrayBuffer()) };
}

function isScene({ path }: Pick<DroppedFile, 'path'>): boolean {
  return /\.json$/i.test(path);
}

/** The scene, or else the characters: the others are what these need. */
function namesOf(files: readonly DroppedFile[]): string {
  const named = [files.filter(isScene), files.filter(isCharacter), files];
  return pathsOf(named.find(({ length }) => length > 0)!);
}

function pathsOf(files: readonly Pick<DroppedFile, 'path'>[]): string {
  return files.map(({ path }) => path).join(', ');
}

/**
 * Names the characters as in the report. A saved scene names the files that the report was made
 * from.
 */
function asReported(opened: Opened, report: Report): Opened {
  const characters = opened.characters.map((facts) =>
    typeof facts.source === 'string'
      ? { ...facts, source: originalPath(report, facts.source) }
      : facts,
  );
  return { ...opened, characters, scene: opened.scene && { ...opened.scene, name: report.title } };
}
