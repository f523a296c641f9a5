/** The boxes of one level of the trees, coloured by what a query did with them. */

import {
  Color,
  Float32BufferAttribute,
  Group,
  InstancedBufferAttribute,
  InstancedBufferGeometry,
  InstancedInterleavedBuffer,
  InterleavedBufferAttribute,
  LineSegments,
  ShaderMaterial,
  Vector4,
} from 'three';
import type { PosedInstance } from '../worker/protocol';
import { OPENED, REFITTED, UNTOUCHED } from './colours';

/** Indexed by the engine's NodeState. */
const STYLES = [
  { colour: UNTOUCHED, opacity: 0.4 },
  { colour: REFITTED, opacity: 0.8 },
  { colour: OPENED, opacity: 1 },
];

/**
 * Edges of a box. A corner has one bit per axis, set on the high side; edges join corners that
 * differ in one bit.
 */
const EDGES = [0, 1, 2, 3, 4, 5, 6, 7, 0, 2, 1, 3, 4, 6, 5, 7, 0, 4, 1, 5, 2, 6, 3, 7];

const VERTEX = `
  uniform vec4 styles[${STYLES.length}];
  attribute vec3 low, high;
  attribute float state;
  varying vec4 style;
  void main() {
    style = styles[int(state + 0.5)];
    gl_Position = projectionMatrix * modelViewMatrix * vec4(mix(low, high, position), 1.0);
  }`;

const FRAGMENT = `
  varying vec4 style;
  void main() {
    gl_FragColor = style;
    #include <colorspace_fragment>
  }`;

/** Boxes of all instances. */
export class NodeBoxes extends Group {
  private lines: BoxLines[] = [];

  show(instances: readonly PosedInstance[]): void {
    while (this.lines.length < instances.length) this.addLines();
    this.lines.forEach((lines, i) => lines.show(instances[i]));
  }

  private addLines(): void {
    const lines = new BoxLines();
    this.lines.push(lines);
    this.add(lines);
  }
}

const material = new ShaderMaterial({
  vertexShader: VERTEX,
  fragmentShader: FRAGMENT,
  uniforms: { styles: { value: STYLES.map(styleVector) } },
  transparent: true,
  depthWrite: false,
});

/** Boxes of one instance, from the worker: one instance of the unit cube per box. */
class BoxLines extends LineSegments<InstancedBufferGeometry> {
  constructor() {
    const cube = new InstancedBufferGeometry();
    const corners = EDGES.flatMap((corner) => [corner & 1, (corner >> 1) & 1, corner >> 2]);
    cube.setAttribute('position', new Float32BufferAttribute(corners, 3));
    super(cube, material);
    this.frustumCulled = false;
  }

  /** Frees the memory of boxes that are not drawn. */
  show(posed: PosedInstance | undefined): void {
    const count = posed?.boxStates.length ?? 0;
    this.visible = count > 0;
    if (!posed || count === 0) return this.forget();
    const boxes = new InstancedInterleavedBuffer(posed.boxes, 6);
    this.geometry.dispose();
    this.geometry.setAttribute('low', new InterleavedBufferAttribute(boxes, 3, 0));
    this.geometry.setAttribute('high', new InterleavedBufferAttribute(boxes, 3, 3));
    this.geometry.setAttribute('state', new InstancedBufferAttribute(posed.boxStates, 1));
    this.geometry.instanceCount = count;
  }

  private forget(): void {
    if (!this.geometry.hasAttribute('state')) return;
    this.geometry.dispose();
    for (const name of ['low', 'high', 'state']) this.geometry.deleteAttribute(name);
  }
}

function styleVector({ colour, opacity }: { colour: number; opacity: number }): Vector4 {
  const { r, g, b } = new Color(colour);
  return new Vector4(r, g, b, opacity);
}
