/** Draws the state. Redraws only when something visible has changed. */

import {
  Box3,
  BufferAttribute,
  BufferGeometry,
  Matrix4,
  Mesh,
  MeshStandardMaterial,
  Quaternion,
  Vector3,
} from 'three';
import { frameTime, placeAt, translationFor } from '../scene/scene';
import { betterSide } from '../scene/sides';
import type { Instance, Scene } from '../scene/types';
import type { AnsweredShot, CameraMove, State } from '../state/state';
import type {
  CharacterFacts,
  Glow as Contacts,
  PosedInstance,
  Shot,
  Surface,
} from '../worker/protocol';
import { ClosestLines } from './closest_lines';
import { type Ambience, bodyColour, DARK, LIGHT } from './colours';
import { Gizmo } from './gizmo';
import { Glow } from './glow';
import { NodeBoxes } from './node_boxes';
import { type PointerEvents, watchPointer } from './pointer';
import { Studio } from './studio';
import { upload } from './upload';

export interface ViewEvents extends PointerEvents {
  onPlace: (instance: number, change: Partial<Instance>) => void;
  /** Called when the handles are let go. */
  onPlaced: () => void;
}

export class View {
  private readonly studio: Studio;
  private readonly glow = new Glow();
  private readonly closest = new ClosestLines();
  private readonly boxes = new NodeBoxes();
  private readonly gizmo: Gizmo;
  private figures: Figure[] = [];
  private shown: State | null = null;
  private ambience: Ambience | null = null;
  /** The spot that the camera went to last. */
  private visited: Shot['moment'] | Shot['spot'] = null;

  constructor(
    container: HTMLElement,
    private readonly events: ViewEvents,
  ) {
    this.studio = new Studio(container);
    const { camera, canvas, orbit, scene } = this.studio;
    this.gizmo = new Gizmo(camera, canvas, orbit, {
      onMove: (place, rotation) => this.place(place, rotation),
      onEnd: events.onPlaced,
      onChange: () => this.studio.redraw(),
    });
    scene.add(this.glow, this.closest, this.boxes, this.gizmo.helper);
    watchPointer(canvas, camera, {
      onPoint: (ray, x, y) => events.onPoint(this.gizmo.isHeld ? null : ray, x, y),
      onClick: (ray) => this.gizmo.isHeld || events.onClick(ray),
    });
  }

  light(isDark: boolean): void {
    const ambience = isDark ? DARK : LIGHT;
    if (ambience === this.ambience) return;
    this.ambience = ambience;
    this.studio.light(ambience);
  }

  show(state: State): void {
    const before = this.shown;
    this.shown = state;
    if (state.characters !== before?.characters) this.frame(state);
    else if (state.arranged !== before.arranged) this.frame(state);
    if (state.side && state.side !== before?.side) this.studio.turnTo(state.side);
    const { cameraMove } = state;
    if (cameraMove && cameraMove !== before?.cameraMove) this.move(cameraMove);
    if (state.answer && state.answer !== before?.answer) {
      this.showAnswer(state, state.answer);
      this.visit(state.answer);
    }
    if (state.hidden !== before?.hidden && state.answer) this.showAnswer(state, state.answer);
    this.showGizmo(state);
  }

  /** The address of a small picture of another answer, which has contacts, from a side of them. */
  photograph(answer: AnsweredShot, side: Instance['translation']): string {
    const state = this.shown!;
    this.boxes.visible = this.gizmo.helper.visible = false;
    this.showAnswer(state, answer);
    const picture = this.studio.photograph(boxAround(answer.glow), side);
    this.boxes.visible = this.gizmo.helper.visible = true;
    if (state.answer) this.showAnswer(state, state.answer);
    return picture;
  }

  private frame({ scene, characters }: State): void {
    if (!scene) return;
    const box = sceneBox(scene, characters);
    const isWalk = scene.instances.some(({ velocity }) => velocity.some((speed) => speed !== 0));
    this.studio.frame(box, isWalk ? 'walking' : 'standing');
    this.glow.scaleTo(box.max.y - box.min.y);
  }

  private move(move: CameraMove): void {
    if (move.kind === 'whole') this.studio.seeWhole();
    else if (move.kind === 'turn') this.studio.turnCamera(move.right, move.up);
    else this.studio.zoom(move.factor);
  }

  /** The camera goes once to what has been chosen, and round to where it is seen. */
  private visit({ shot, spot }: AnsweredShot): void {
    const chosen = shot.moment ?? shot.spot;
    if (chosen === this.visited) return;
    this.visited = chosen;
    if (!spot || spot.glow.triangles === 0) return;
    this.studio.lookAt(boxAround(spot.glow), (present) => betterSide(spot.seen, present));
  }

  private showAnswer({ characters, hidden }: State, answer: AnsweredShot): void {
    const { shot, instances, glow, closest, spot } = answer;
    const cast = shot.scene.instances.map(({ character }) => characters[character]);
    const fits =
      cast.length === this.figures.length && this.figures.every((f, i) => f.character === cast[i]);
    if (!fits) this.replaceFigures(cast.map((character, i) => new Figure(character, i)));
    this.figures.forEach((figure, i) => {
      figure.visible = !hidden.has(i);
      figure.show(instances[i]);
    });
    this.glow.show(glow, spot?.glow ?? null);
    const isShown = ({ instance }: Surface) => !hidden.has(instance);
    this.closest.show(closest.filter(({ a, b }) => isShown(a) && isShown(b)));
    this.boxes.show(instances.filter((_, i) => !hidden.has(i)));
    this.studio.redraw();
  }

  private replaceFigures(figures: Figure[]): void {
    for (const figure of this.figures) {
      figure.removeFromParent();
      figure.dispose();
    }
    this.figures = figures;
    this.studio.scene.add(...figures);
  }

  private showGizmo({ scene, selected, frame, gizmo }: State): void {
    if (!scene || selected === null || gizmo === null) return this.gizmo.hide();
    const instance = scene.instances[selected];
    this.gizmo.show(placeAt(instance, frameTime(scene, frame)), instance.rotation, gizmo);
  }

  private place(place: Instance['translation'], rotation: Instance['rotation']): void {
    const { scene, selected, frame } = this.shown!;
    if (!scene || selected === null) return;
    const instance = scene.instances[selected];
    const translation = translationFor(place, instance, frameTime(scene, frame));
    this.events.onPlace(selected, { translation, rotation });
  }
}

function boxAround({ corners, triangles }: Contacts): Box3 {
  return new Box3().setFromArray(corners.subarray(0, 9 * triangles));
}

/** Box of all characters over all frames. */
function sceneBox(scene: Scene, characters: readonly CharacterFacts[]): Box3 {
  const all = new Box3();
  for (const instance of scene.instances) {
    for (const frame of [0, scene.frameCount - 1]) {
      all.union(boxAt(instance, characters[instance.character], frameTime(scene, frame)));
    }
  }
  return all;
}

function boxAt(instance: Instance, { extent }: CharacterFacts, time: number): Box3 {
  const placement = new Matrix4().compose(
    new Vector3(...placeAt(instance, time)),
    new Quaternion(...instance.rotation),
    new Vector3().setScalar(instance.scale),
  );
  const box = new Box3(new Vector3(...extent.low), new Vector3(...extent.high));
  return box.applyMatrix4(placement);
}

/** Surface of one instance, with the vertices posed by the worker. */
class Figure extends Mesh<BufferGeometry, MeshStandardMaterial> {
  constructor(
    readonly character: CharacterFacts,
    instance: number,
  ) {
    const geometry = new BufferGeometry();
    geometry.setIndex(new BufferAttribute(character.triangles, 1));
    super(geometry, new MeshStandardMaterial({ color: bodyColour(instance), roughness: 0.62 }));
    this.castShadow = true;
    this.receiveShadow = true;
    this.frustumCulled = false; // otherwise its bounds must be recomputed in each frame
  }

  show({ positions, normals }: PosedInstance): void {
    upload(this.geometry, 'position', positions);
    upload(this.geometry, 'normal', normals);
  }

  dispose(): void {
    this.geometry.dispose();
    this.material.dispose();
  }
}
