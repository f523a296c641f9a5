/** Handles at the selected instance's feet, to place and turn it. */

import { Object3D, type Camera } from 'three';
import type { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { TransformControls } from 'three/addons/controls/TransformControls.js';
import type { Quaternion, Vector3 } from '../scene/types';
import { ACCENT, AXES } from './colours';

const MODES = { move: 'translate', turn: 'rotate' } as const;

export interface GizmoEvents {
  onMove: (place: Vector3, rotation: Quaternion) => void;
  /** Called when the handles are let go. */
  onEnd: () => void;
  /** Called when the picture must be redrawn. */
  onChange: () => void;
}

export class Gizmo {
  readonly helper: Object3D;
  private readonly handle = new Object3D();
  private readonly controls: TransformControls;

  constructor(
    camera: Camera,
    canvas: HTMLCanvasElement,
    orbit: OrbitControls,
    private readonly events: GizmoEvents,
  ) {
    this.controls = new TransformControls(camera, canvas);
    this.controls.setSize(0.7);
    this.controls.setColors(AXES.x, AXES.y, AXES.z, ACCENT);
    this.controls.addEventListener('change', events.onChange);
    this.controls.addEventListener('dragging-changed', ({ value }) => {
      orbit.enabled = !value;
      if (!value) events.onEnd();
    });
    this.controls.addEventListener('objectChange', () => {
      const { position, quaternion } = this.handle;
      events.onMove(position.toArray(), quaternion.toArray() as Quaternion);
    });
    this.helper = new Object3D().add(this.handle, this.controls.getHelper());
  }

  /** Whether a pointer is on one of the handles. */
  get isHeld(): boolean {
    return this.controls.dragging || this.controls.axis !== null;
  }

  show(place: Vector3, rotation: Quaternion, mode: 'move' | 'turn'): void {
    if (this.controls.dragging || this.isAt(place, rotation, mode)) return;
    this.handle.position.set(...place);
    this.handle.quaternion.set(...rotation);
    this.controls.setMode(MODES[mode]);
    this.controls.showX = this.controls.showZ = mode === 'move';
    this.controls.attach(this.handle);
    this.events.onChange();
  }

  hide(): void {
    this.controls.detach();
  }

  private isAt(place: Vector3, rotation: Quaternion, mode: 'move' | 'turn'): boolean {
    const { object, mode: presentMode } = this.controls;
    const { position, quaternion } = this.handle;
    return (
      object === this.handle &&
      presentMode === MODES[mode] &&
      position.toArray().every((value, i) => value === place[i]) &&
      quaternion.toArray().every((value, i) => value === rotation[i])
    );
  }
}
