/** Triangles in contact: lit where they are seen, a shimmer where something is before them. */

import {
  BufferGeometry,
  DoubleSide,
  Group,
  Mesh,
  MeshBasicMaterial,
  Points,
  ShaderMaterial,
  Color,
} from 'three';
import type { Glow as Contacts } from '../worker/protocol';
import { ACCENT } from './colours';
import { upload } from './upload';

const SHIMMER = 0.22;
/** Opacity of contacts outside the selected spot. */
const BESIDE = 0.3;
const HALO_OPACITY = 0.05;

/** Relative to the height of the characters. */
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
  private readonly beside: Mesh;
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
    const before = { polygonOffset: true, polygonOffsetFactor: -2, polygonOffsetUnits: -2 };
    const seen = new MeshBasicMaterial({ ...surface, ...before });
    const faint = new MeshBasicMaterial({
      ...surface,
      ...before,
      transparent: true,
      opacity: BESIDE,
      depthWrite: false,
    });
    const hidden = new MeshBasicMaterial({
      ...surface,
      transparent: true,
      opacity: SHIMMER,
      depthTest: false,
      depthWrite: false,
    });
    this.beside = new Mesh(new BufferGeometry(), faint);
    this.add(
      this.beside,
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

  /** Shows the contacts of the spot, if there is one, and all others. */
  show(all: Contacts, spot: Contacts | null): void {
    const { triangles, corners, centres } = spot ?? all;
    this.beside.visible = spot !== null;
    if (spot) upload(this.beside.geometry, 'position', all.corners);
    this.beside.geometry.setDrawRange(0, 3 * all.triangles);
    upload(this.triangles, 'position', corners);
    upload(this.centres, 'position', centres);
    this.triangles.setDrawRange(0, 3 * triangles);
    this.centres.setDrawRange(0, triangles);
  }
}
