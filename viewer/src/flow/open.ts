/** From files to characters on the stage, or to a readable complaint. */

import { originalPath, stopsAtFirst, type Report } from '../report/report';
import * as changes from '../state/changes';
import type { State } from '../state/state';
import type { Store } from '../state/store';
import { isCharacter, type NamedFile, type Opened } from '../worker/protocol';
import type { Client } from './client';
import type { DroppedFile } from './drops';

/** In the midst of it. */
const FIRST_FRAME_OF_DEMO = 76;

export class Opener {
  private opening = Promise.resolve();

  constructor(
    private readonly store: Store<State>,
    private readonly client: Client,
  ) {}

  openDemo(): void {
    const ask = () => this.client.ask('openDemo', {});
    this.show('the generated characters', ask, FIRST_FRAME_OF_DEMO);
  }

  openReport(report: Report): void {
    const { scene, reading, answer } = report;
    const by = answer?.options.by ?? 'instance';
    this.store.update(() => ({
      report: { ...report, files: {} }, // the worker has them: they may be large
      by,
      firstContact: stopsAtFirst(report),
      listing: answer ? 'clip' : 'frame',
    }));
    this.show(scene, async () => {
      const question = { path: scene, files: report.files, options: reading };
      const opened = await this.client.ask('openReport', question);
      this.store.update(() => ({ reported: opened.scene }));
      return withOriginalPaths(opened, report);
    });
  }

  /** Characters, or a scene with its characters; on the stage they replace all others. */
  openFiles(files: readonly DroppedFile[]): void {
    const names = files.map(({ path }) => path).join(', ');
    this.show(names, async () => this.ask(await Promise.all(files.map(readFile))));
  }

  private ask(files: NamedFile[]): Promise<Opened> {
    const scenes = files.filter(isScene);
    if (scenes.length > 1) {
      throw new Error(`Several scenes are in it: drop only one of ${pathsOf(scenes)}.`);
    }
    const [scene] = scenes;
    if (scene) return this.client.ask('openScene', { path: scene.path, files, options: {} });
    if (files.some(isCharacter)) return this.client.ask('readCharacters', { files });
    throw new Error('No character is in it: drop .glb files, or a scene.json with its files.');
  }

  /** One after the other. The stage keeps what it has until all is read. */
  private show(what: string, ask: () => Promise<Opened>, frame = 0): void {
    this.opening = this.opening.then(async () => {
      this.store.update(() => ({ reading: what }));
      try {
        this.store.update(changes.open(await ask(), frame));
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

function isScene({ path }: NamedFile): boolean {
  return /\.json$/i.test(path);
}

function pathsOf(files: readonly NamedFile[]): string {
  return files.map(({ path }) => path).join(', ');
}

/** A scene that is saved names the files that the report was made of. */
function withOriginalPaths(opened: Opened, report: Report): Opened {
  const characters = opened.characters.map((facts) =>
    typeof facts.source === 'string'
      ? { ...facts, source: originalPath(report, facts.source) }
      : facts,
  );
  return { ...opened, characters };
}
