/** Rays under the pointer, and clicks that are no drags. */

import { Raycaster, Vector2, type Camera } from 'three';

export interface Ray {
  origin: number[];
  direction: number[];
}

const CLICK_PIXELS = 4;

export interface PointerEvents {
  /** Called with the position on the page; null when the pointer has left. */
  onPoint: (ray: Ray | null, x: number, y: number) => void;
  onClick: (ray: Ray) => void;
}

export function watchPointer(canvas: HTMLCanvasElement, camera: Camera, events: PointerEvents) {
  const caster = new Raycaster();
  const rayAt = (x: number, y: number): Ray => {
    caster.setFromCamera(onScreen(canvas, x, y), camera);
    const { origin, direction } = caster.ray;
    return { origin: origin.toArray(), direction: direction.toArray() };
  };
  let pressed = { x: 0, y: 0 };

  canvas.addEventListener('pointermove', ({ clientX, clientY, buttons }) => {
    if (buttons !== 0) return events.onPoint(null, clientX, clientY);
    events.onPoint(rayAt(clientX, clientY), clientX, clientY);
  });
  canvas.addEventListener('pointerleave', () => events.onPoint(null, 0, 0));
  canvas.addEventListener('pointerdown', ({ clientX, clientY }) => {
    pressed = { x: clientX, y: clientY };
  });
  canvas.addEventListener('click', ({ clientX, clientY }) => {
    const distance = Math.hypot(clientX - pressed.x, clientY - pressed.y);
    if (distance <= CLICK_PIXELS) events.onClick(rayAt(clientX, clientY));
  });
}

/** Coordinates from -1 to 1, y up. */
function onScreen(canvas: HTMLCanvasElement, x: number, y: number): Vector2 {
  const { left, top, width, height } = canvas.getBoundingClientRect();
  return new Vector2((2 * (x - left)) / width - 1, 1 - (2 * (y - top)) / height);
}
