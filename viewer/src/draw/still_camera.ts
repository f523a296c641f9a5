/** Small square pictures, drawn into a render target: the canvas on screen stays as it is. */

import { SRGBColorSpace, WebGLRenderTarget } from 'three';
import type { PerspectiveCamera, Scene, WebGLRenderer } from 'three';

/** Pixels along each side. */
const SIZE = 192;

export class StillCamera {
  private readonly target = new WebGLRenderTarget(SIZE, SIZE, {
    colorSpace: SRGBColorSpace,
    internalFormat: 'RGBA8', // otherwise colours would be encoded twice
    samples: 4,
  });

  constructor(private readonly renderer: WebGLRenderer) {
    // three.js maps tones and encodes colours as on screen only for targets with this mark.
    Object.assign(this.target, { isXRRenderTarget: true });
  }

  /** Returns the address of an image. */
  take(scene: Scene, from: PerspectiveCamera): string {
    const camera = from.clone();
    camera.aspect = 1;
    camera.updateProjectionMatrix();
    this.renderer.setRenderTarget(this.target);
    this.renderer.render(scene, camera);
    this.renderer.setRenderTarget(null);
    const pixels = new Uint8Array(4 * SIZE * SIZE);
    this.renderer.readRenderTargetPixels(this.target, 0, 0, SIZE, SIZE, pixels);
    return addressOf(pixels);
  }
}

/** `pixels` are premultiplied by their opacity, the lowest row first. */
function addressOf(pixels: Uint8Array): string {
  const canvas = Object.assign(document.createElement('canvas'), { width: SIZE, height: SIZE });
  const context = canvas.getContext('2d')!;
  const image = context.createImageData(SIZE, SIZE);
  for (let row = 0; row < SIZE; ++row) {
    const line = pixels.subarray(4 * SIZE * (SIZE - 1 - row), 4 * SIZE * (SIZE - row));
    image.data.set(divided(line), 4 * SIZE * row);
  }
  context.putImageData(image, 0, 0);
  return canvas.toDataURL();
}

function divided(pixels: Uint8Array): Uint8ClampedArray {
  return Uint8ClampedArray.from(pixels, (value, i) => {
    const opacity = pixels[i | 3];
    return i % 4 === 3 || opacity === 0 ? value : (255 * value) / opacity;
  });
}
