/**
 * Triangles in contact: lit where they are seen, a shimmer where something is before them. Contacts of
 * characters with themselves have their own colour.
 */

import {
  BufferGeometry,
  Color,
  DoubleSide,
  Group,
  Mesh,
  MeshBasicMaterial,
  Points,
  ShaderMaterial,
  type MeshBasicMaterialParameters,
} from 'three';
import type { Glow as Contacts } from '../worker/protocol';
import { ACCENT, SELF_ACCENT } from './colours';
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

/** Colours of the two groups of triangles. */
const COLOURS = [SELF_ACCENT, ACCENT];

const IN_FRONT = { polygonOffset: true, polygonOffsetFactor: -2, polygonOffsetUnits: -2 };

export class Glow extends Group {
  private readonly triangles = new BufferGeometry();
  private readonly beside: Mesh;
  private readonly centres = new BufferGeometry();
  private readonly halos = COLOURS.map(makeHalo);

  constructor() {
    super();
    const seen = surfaces(IN_FRONT);
    const faint = surfaces({
      ...IN_FRONT,
      transparent: true,
      opacity: BESIDE,
      depthWrite: false,
    });
    const hidden = surfaces({
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
      new Points(this.centres, this.halos),
    );
    for (const child of this.children) child.frustumCulled = false;
  }

  scaleTo(height: number): void {
    for (const { uniforms } of this.halos) uniforms.size.value = HALO_SIZE * height;
  }

  /** Shows the contacts of the spot, if there is one, and all others. */
  show(all: Contacts, spot: Contacts | null): void {
    const shown = spot ?? all;
    this.beside.visible = spot !== null;
    if (spot) upload(this.beside.geometry, 'position', all.corners);
    divide(this.beside.geometry, all, 3);
    upload(this.triangles, 'position', shown.corners);
    upload(this.centres, 'position', shown.centres);
    divide(this.triangles, shown, 3);
    divide(this.centres, shown, 1);
  }
}

/** Colours contacts of characters with themselves apart from the others. */
function divide(geometry: BufferGeometry, { triangles, ofSelf }: Contacts, each: number): void {
  geometry.clearGroups();
  geometry.addGroup(0, each * ofSelf, 0);
  geometry.addGroup(each * ofSelf, each * (triangles - ofSelf), 1);
}

function surfaces(look: MeshBasicMaterialParameters): MeshBasicMaterial[] {
  return COLOURS.map(
    (color) => new MeshBasicMaterial({ color, side: DoubleSide, toneMapped: false, ...look }),
  );
}

function makeHalo(colour: number): ShaderMaterial {
  return new ShaderMaterial({
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT,
    uniforms: {
      colour: { value: new Color(colour) },
      opacity: { value: HALO_OPACITY },
      size: { value: HALO_SIZE },
      heightInPixels: { value: 1 },
    },
    transparent: true,
    depthWrite: false,
    depthTest: false,
  });
}
