/** From files to characters on the stage, or to a readable complaint. */

import { filesOf, type Report } from '../report/report';
import * as changes from '../state/changes';
import type { State } from '../state/state';
import type { Store } from '../state/store';
import type { NamedFile, Opened } from '../worker/protocol';
import type { Client } from './client';

export class Opener {
  constructor(
    private readonly store: Store<State>,
    private readonly client: Client,
  ) {}

  openDemo(): Promise<void> {
    return this.show('the generated characters', this.client.ask('openDemo', {}));
  }

  openReport(report: Report): Promise<void> {
    const { scene, reading, firstContact } = report;
    const question = { path: scene, files: filesOf(report), options: reading };
    this.store.update(() => ({ report, firstContact, listing: 'clip' }));
    return this.show(scene, this.client.ask('openScene', question));
  }

  /** Characters, or a scene with its characters; on the stage they replace all others. */
  async openFiles(files: readonly File[]): Promise<void> {
    const names = files.map((file) => file.name).join(', ');
    const named = await Promise.all(files.map(readFile));
    const scene = named.find(({ path }) => /\.json$/i.test(path));
    if (scene) {
      const question = { path: scene.path, files: named, options: {} };
      return this.show(names, this.client.ask('openScene', question));
    }
    if (named.some(({ path }) => /\.(glb|gltf)$/i.test(path))) {
      return this.show(names, this.client.ask('readCharacters', { files: named }));
    }
    this.store.update(
      changes.refuse(names, 'is no character: drop .glb files, or a scene.json with its files'),
    );
  }

  /** The stage keeps what it has until all is read. */
  private async show(what: string, opened: Promise<Opened>): Promise<void> {
    this.store.update(() => ({ reading: what }));
    try {
      this.store.update(changes.open(await opened));
    } catch (error) {
      this.store.update(changes.refuse(`${what} could not be opened`, (error as Error).message));
    }
  }
}

async function readFile(file: File): Promise<NamedFile> {
  return { path: file.name, bytes: new Uint8Array(await file.arrayBuffer()) };
}
