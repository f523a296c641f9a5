/** From files to characters on the stage, or to a readable complaint. */

import { filesOf, type Report } from '../report/report';
import * as changes from '../state/changes';
import type { State } from '../state/state';
import type { Store } from '../state/store';
import { isCharacter, type NamedFile, type Opened } from '../worker/protocol';
import type { Client } from './client';

export class Opener {
  private opening = Promise.resolve();

  constructor(
    private readonly store: Store<State>,
    private readonly client: Client,
  ) {}

  openDemo(): void {
    this.show('the generated characters', () => this.client.ask('openDemo', {}));
  }

  openReport(report: Report): void {
    const { scene, reading, firstContact } = report;
    const question = { path: scene, files: filesOf(report), options: reading };
    this.store.update(() => ({ report, firstContact, listing: 'clip' }));
    this.show(scene, () => this.client.ask('openScene', question));
  }

  /** Characters, or a scene with its characters; on the stage they replace all others. */
  openFiles(files: readonly File[]): void {
    const names = files.map((file) => file.name).join(', ');
    this.show(names, async () => this.ask(await Promise.all(files.map(readFile))));
  }

  private ask(files: NamedFile[]): Promise<Opened> {
    const scene = files.find(({ path }) => /\.json$/i.test(path));
    if (scene) return this.client.ask('openScene', { path: scene.path, files, options: {} });
    if (files.some(isCharacter)) return this.client.ask('readCharacters', { files });
    throw new Error('No character is in it: drop .glb files, or a scene.json with its files.');
  }

  /** One after the other. The stage keeps what it has until all is read. */
  private show(what: string, ask: () => Promise<Opened>): void {
    this.opening = this.opening.then(async () => {
      this.store.update(() => ({ reading: what }));
      try {
        this.store.update(changes.open(await ask()));
      } catch (error) {
        this.store.update(changes.refuse(`${what} could not be opened`, (error as Error).message));
      }
    });
  }
}

async function readFile(file: File): Promise<NamedFile> {
  return { path: file.name, bytes: new Uint8Array(await file.arrayBuffer()) };
}
