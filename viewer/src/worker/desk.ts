/** Takes requests to those who can answer them, and holds the characters. */

import type { Pelt, Scene as EngineScene } from 'pelt';
import type { Scene } from '../scene/scene';
import { readCharacters, readDemo, readSceneFile, type Cast } from './cast';
import { measureCosts } from './costs';
import { factsOf } from './facts';
import { answerFrame } from './frame';
import { Poses } from './poses';
import type { Answers, Kind, Opened, Questions, Request, SweepProgress } from './protocol';
import { firstSurface } from './surfaces';
import { Sweep } from './sweep';

export class Desk {
  private cast: Cast = { characters: [], sources: [], scene: null };
  /** As the page shows them, and the same again for what is asked apart from that. */
  private readonly shown = new Poses();
  private readonly apart = new Poses();
  private sweep: Sweep | null = null;

  constructor(
    private readonly pelt: Pelt,
    private readonly report: (progress: SweepProgress) => void,
  ) {}

  answer({ kind, question }: Request): Answers[Kind] {
    switch (kind) {
      case 'openDemo':
        return this.replaceCast(readDemo(this.pelt));
      case 'openScene':
        return this.replaceCast(readSceneFile(this.pelt, question));
      case 'readCharacters':
        return this.replaceCast(readCharacters(this.pelt, question.files));
      case 'pose':
        return answerFrame(this.pelt, this.shown, this.engineScene(question.scene), question);
      case 'still':
        return answerFrame(this.pelt, this.apart, this.engineScene(question.scene), question);
      case 'measure':
        return measureCosts(this.pelt, this.apart, this.engineScene(question.scene), question);
      case 'cast':
        return firstSurface(this.shown.all, question.origin, question.direction);
      case 'sweep':
        return this.startSweep(question);
    }
  }

  /** Only once the new ones have been read are the old ones given up. */
  private replaceCast(cast: Cast): Opened {
    this.stopSweep();
    this.shown.clear();
    this.apart.clear();
    for (const character of this.cast.characters) character.delete();
    this.cast = cast;
    return {
      characters: cast.characters.map((c, i) => factsOf(c, cast.sources[i])),
      scene: cast.scene,
    };
  }

  private startSweep(question: Questions['sweep']): null {
    this.stopSweep();
    this.sweep = new Sweep(this.pelt, this.engineScene(question.scene), question, this.report);
    return null;
  }

  private stopSweep(): void {
    this.sweep?.stop();
    this.sweep = null;
  }

  private engineScene({ frameCount, fps, instances }: Scene): EngineScene {
    return this.pelt.makeScene({ characters: this.cast.characters, frameCount, fps, instances });
  }
}
