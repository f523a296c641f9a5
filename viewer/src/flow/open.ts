/** Opens files as characters of the scene, or reports a readable error. */

import { filesWithClip, reelOf, worstClip } from '../report/clips';
import { budgetOf, clearanceOf, limitOf, originalPath, type Report } from '../report/report';
import { fileOf, withFile } from '../scene/scene';
import * as changes from '../state/changes';
import * as edits from '../state/edits';
import type { Change, Problem, State } from '../state/state';
import type { Store } from '../state/store';
import {
  isCharacter,
  type NamedFile,
  type Opened,
  type ReadCharacters,
  type ReadingOptions,
} from '../worker/protocol';
import type { Client } from './client';
import type { DroppedFile } from './drops';

/** A frame with many contacts. */
const FIRST_FRAME_OF_DEMO = 76;

export class Opener {
  private opening = Promise.resolve();
  /** The files on the stage, if they were dropped. */
  private dropped: readonly DroppedFile[] = [];

  constructor(
    private readonly store: Store<State>,
    private readonly client: Client,
  ) {}

  openDemo(): void {
    const ask = () => this.client.ask('openDemo', {});
    const begin = { frame: FIRST_FRAME_OF_DEMO };
    this.read('the generated characters', async () => changes.open(await ask(), begin));
  }

  /** Opens a report, paused at its worst frame if it has contacts. */
  openReport(given: Report): void {
    const reel = reelOf(given);
    const clip = reel && worstClip(reel);
    const files = clip ? filesWithClip(given, clip) : given.files;
    const report = clip?.report ?? { ...given, files: {} }; // the worker has them: they may be large
    const { scene, title, reading, answer } = report;
    const by = answer?.options.by ?? 'instance';
    const maxContacts = limitOf(report);
    const clearance = clearanceOf(report);
    const budget = budgetOf(report);
    this.store.update(({ lastMaxContacts }) => ({
      report,
      reel,
      by,
      maxContacts,
      lastMaxContacts: maxContacts ?? lastMaxContacts,
      clearance,
      budget,
      listing: answer ? 'clip' : 'frame',
    }));
    this.read(title, async () => {
      const question = { path: scene, files, options: reading };
      const opened = asReported(await this.client.ask('openReport', question), report);
      return changes.openReported(opened, report);
    });
  }

  /** Characters, or a scene with its characters; on the stage they replace all others. */
  openFiles(files: readonly DroppedFile[], options: ReadingOptions = {}): void {
    const remedy = renormalising(() => this.openFiles(files, { ...options, renormalise: true }));
    this.read(
      namesOf(files),
      async () => {
        const opened = await this.ask(await Promise.all(files.map(readFile)), options);
        this.dropped = files;
        return changes.open(opened, { readingOptions: options });
      },
      remedy,
    );
  }

  /** Characters beside those on the stage. */
  addFiles(files: readonly DroppedFile[]): void {
    const options = { ...this.store.state.readingOptions, renormalise: true };
    const remedy = renormalising(() => this.openFiles([...this.dropped, ...files], options));
    this.read(
      namesOf(files),
      async () => {
        const added = await this.askToAdd(files);
        this.dropped = [...this.dropped, ...files];
        return edits.add(added);
      },
      remedy,
    );
  }

  private ask(files: NamedFile[], options: ReadingOptions): Promise<Opened> {
    const scenes = files.filter(isScene);
    if (scenes.length > 1) {
      throw new Error(`There are several scenes: drop only one of ${pathsOf(scenes)}.`);
    }
    const [scene] = scenes;
    if (scene) return this.client.ask('openScene', { path: scene.path, files, options });
    if (files.some(isCharacter)) return this.client.ask('readCharacters', { files, options });
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

  /** Reads one selection after the other. The scene is unchanged until everything is read. */
  private read(
    what: string,
    ask: () => Promise<Change>,
    remedyFor: (message: string) => Problem['remedy'] = () => undefined,
  ): void {
    this.opening = this.opening.then(async () => {
      this.store.update(() => ({ reading: what }));
      try {
        this.store.update(await ask());
        this.store.update(changes.offerRemedies(remedyFor));
      } catch (error) {
        this.store.update(() => ({ reading: null }));
        const { message } = error as Error;
        const title = `${what} could not be opened`;
        this.store.update(changes.refuse(title, message, remedyFor(message)));
      }
    });
  }
}

/** Weights that do not sum to 1 can be divided by their sums. */
function renormalising(act: () => void): (message: string) => Problem['remedy'] {
  const label = 'Read again, with weights divided by their sums';
  return (message) => (message.includes('renormalise: true') ? { label, act } : undefined);
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
  const characters = opened.characters.map((facts) => {
    const file = fileOf(facts.source);
    if (file === null) return facts;
    return { ...facts, source: withFile(facts.source, originalPath(report, file)) };
  });
  return { ...opened, characters, scene: opened.scene && { ...opened.scene, name: report.title } };
}
