/** Triangles in contact: lit where they are seen, a shimmer where something is before them. */

import {
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  Group,
  Mesh,
  MeshBasicMaterial,
  Points,
  ShaderMaterial,
  Color,
} from 'three';
import type { CharacterFacts, PosedInstance } from '../worker/protocol';
import { ACCENT } from './colours';

const SHIMMER = 0.22;
const HALO_OPACITY = 0.05;

/** Of the characters' height. */
const HALO_SIZE = 0.05;

const VERTEX = `
  uniform float size, heightInPixels;
  void main() {
    vec4 seen = modelViewMatrix * vec4(position, 1.0);
    gl_Position = projectionMatrix * seen;
    gl_PointSize = size * heightInPixels * projectionMatrix[1][1] / gl_Position.w;
  }`;

const FRAGMENT = `
  uniform vec3 colour;
  uniform float opacity;
  void main() {
    float nearness = max(0.0, 1.0 - 2.0 * length(gl_PointCoord - 0.5));
    gl_FragColor = vec4(colour, opacity * nearness * nearness);
    #include <colorspace_fragment>
  }`;

export class Glow extends Group {
  private readonly triangles = new BufferGeometry();
  private readonly centres = new BufferGeometry();
  private readonly halo = new ShaderMaterial({
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT,
    uniforms: {
      colour: { value: new Color(ACCENT) },
      opacity: { value: HALO_OPACITY },
      size: { value: HALO_SIZE },
      heightInPixels: { value: 1 },
    },
    transparent: true,
    depthWrite: false,
    depthTest: false,
  });

  constructor() {
    super();
    const surface = { color: ACCENT, side: DoubleSide, toneMapped: false };
    const seen = new MeshBasicMaterial({
      ...surface,
      polygonOffset: true,
      polygonOffsetFactor: -2,
      polygonOffsetUnits: -2,
    });
    const hidden = new MeshBasicMaterial({
      ...surface,
      transparent: true,
      opacity: SHIMMER,
      depthTest: false,
      depthWrite: false,
    });
    this.add(
      new Mesh(this.triangles, seen),
      new Mesh(this.triangles, hidden),
      new Points(this.centres, this.halo),
    );
    for (const child of this.children) child.frustumCulled = false;
  }

  scaleTo(height: number): void {
    this.halo.uniforms.size.value = HALO_SIZE * height;
  }

  resize(heightInPixels: number): void {
    this.halo.uniforms.heightInPixels.value = heightInPixels;
  }

  show(characters: readonly CharacterFacts[], instances: readonly PosedInstance[]): void {
    const positions = cornersOf(characters, instances);
    this.triangles.dispose();
    this.centres.dispose();
    this.triangles.setAttribute('position', new BufferAttribute(positions, 3));
    this.centres.setAttribute('position', new BufferAttribute(centresOf(positions), 3));
  }
}

/** Of all triangles in contact, one after the other. */
function cornersOf(
  characters: readonly CharacterFacts[],
  instances: readonly PosedInstance[],
): Float32Array {
  const count = instances.reduce((sum, { touching }) => sum + touching.length, 0);
  const corners = new Float32Array(9 * count);
  let next = 0;
  instances.forEach(({ touching, positions }, i) => {
    const { triangles } = characters[i];
    for (const triangle of touching) {
      for (let corner = 3 * triangle; corner < 3 * triangle + 3; ++corner) {
        const vertex = 3 * triangles[corner];
        for (let axis = 0; axis < 3; ++axis) corners[next++] = positions[vertex + axis];
      }
    }
  });
  return corners;
}

function centresOf(corners: Float32Array): Float32Array {
  return Float32Array.from({ length: corners.length / 3 }, (_, i) => {
    const first = 9 * Math.floor(i / 3) + (i % 3);
    return (corners[first] + corners[first + 3] + corners[first + 6]) / 3;
  });
}
