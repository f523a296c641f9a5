/** Takes requests to those who can answer them, and holds the characters. */

import type { Pelt, Scene as EngineScene } from 'pelt';
import type { Scene } from '../scene/types';
import { decodeFiles, factsOf, readCharacters, readDemo, readSceneFile, type Cast } from './cast';
import { CostMeter } from './costs';
import { answerFrame, answerStill } from './frame';
import { SelfFilters } from './own_contacts';
import type {
  Answers,
  Kind,
  Opened,
  Questions,
  ReadCharacters,
  Request,
  SweepProgress,
} from './protocol';
import { Stage } from './stage';
import { firstSurface } from './surfaces';
import { Sweep } from './sweep';

export class Desk {
  private cast: Cast = { characters: [], sources: [], scene: null, self: {}, refused: [] };
  private readonly filters: SelfFilters;
  /** The displayed stage, and a second one for requests that are not displayed. */
  private readonly shown: Stage;
  private readonly apart: Stage;
  private readonly meter: CostMeter;
  private sweep: Sweep | null = null;

  constructor(
    private readonly pelt: Pelt,
    private readonly report: (progress: SweepProgress) => void,
  ) {
    this.filters = new SelfFilters(pelt);
    this.shown = new Stage(pelt, this.filters);
    this.apart = new Stage(pelt, this.filters);
    this.meter = new CostMeter(pelt, this.filters);
  }

  /** Whether the engine has ended. */
  get hasEnded(): boolean {
    return this.pelt.hasEnded;
  }

  answer({ kind, question }: Request): Answers[Kind] | Promise<Answers[Kind]> {
    switch (kind) {
      case 'openDemo':
        return this.replaceCast(readDemo(this.pelt));
      case 'openScene':
        return this.replaceCast(readSceneFile(this.pelt, question));
      case 'openReport': {
        const files = decodeFiles(question.files);
        return this.replaceCast(readSceneFile(this.pelt, { ...question, files }));
      }
      case 'readCharacters':
        return this.replaceCast(readCharacters(this.pelt, question.files, question.options));
      case 'addCharacters':
        return this.addCast(readCharacters(this.pelt, question.files, question.options));
      case 'pose': {
        const { shot, spares } = question;
        return answerFrame(this.pelt, this.shown, this.engineScene(shot.scene), shot, spares);
      }
      case 'still':
        return answerStill(this.pelt, this.apart, this.engineScene(question.scene), question);
      case 'measure':
        return this.meter.advance(question, this.engineScene(question.shot.scene));
      case 'cast':
        return firstSurface(this.shown.poses, question);
      case 'sweep':
        return this.startSweep(question);
    }
  }

  /** Releases the old characters only after the new ones have been read. */
  private replaceCast(cast: Cast): Opened {
    this.stopSweep();
    this.shown.clear();
    this.apart.clear();
    this.meter.clear();
    this.filters.clear();
    for (const character of this.cast.characters) character.delete();
    this.cast = cast;
    return { ...readOf(cast), scene: cast.scene, self: cast.self };
  }

  private addCast(added: Cast): ReadCharacters {
    const characters = [...this.cast.characters, ...added.characters];
    this.cast = { ...this.cast, characters, sources: [...this.cast.sources, ...added.sources] };
    return readOf(added);
  }

  private startSweep(question: Questions['sweep']): Promise<null> {
    this.stopSweep();
    const scene = this.engineScene(question.scene);
    this.sweep = new Sweep(this.pelt, this.filters, scene, question, this.report);
    return this.sweep.ended;
  }

  private stopSweep(): void {
    this.sweep?.stop();
    this.sweep = null;
  }

  private engineScene({ name: _, ...scene }: Scene): EngineScene {
    return this.pelt.makeScene({ characters: this.cast.characters, ...scene });
  }
}

function readOf({ characters, sources, refused }: Cast): ReadCharacters {
  return { characters: characters.map((c, i) => factsOf(c, sources[i])), refused };
}
