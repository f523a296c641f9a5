/** A floor that takes shadows, with lines that fade into the distance. */

import {
  Color,
  Group,
  Mesh,
  PlaneGeometry,
  ShaderMaterial,
  ShadowMaterial,
  type Vector3,
} from 'three';
import type { Ambience } from './colours';

/** Relative to the radius of the scene. */
const EXTENT_RADII = 6;

const VERTEX = `
  varying vec2 place;
  void main() {
    place = position.xy;
    gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  }`;

const FRAGMENT = `
  uniform vec3 colour;
  uniform float opacity, cells;
  varying vec2 place;

  float lines(vec2 at) {
    vec2 width = fwidth(at);
    vec2 distance = abs(fract(at - 0.5) - 0.5) / width;
    return 1.0 - min(min(distance.x, distance.y), 1.0);
  }

  void main() {
    float fade = pow(max(0.0, 1.0 - 2.0 * length(place)), 2.0);
    float fine = 0.35 * lines(place * cells), coarse = lines(place * cells / 5.0);
    gl_FragColor = vec4(colour, opacity * fade * max(fine, coarse));
  }`;

export class Ground extends Group {
  private readonly shadow = new ShadowMaterial({ depthWrite: false });
  private readonly lines = new ShaderMaterial({
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT,
    uniforms: { colour: { value: new Color() }, opacity: { value: 1 }, cells: { value: 100 } },
    transparent: true,
    depthWrite: false,
  });

  constructor() {
    super();
    const plane = new PlaneGeometry();
    const floor = new Mesh(plane, this.shadow);
    floor.receiveShadow = true;
    this.add(floor, new Mesh(plane, this.lines));
    this.rotation.x = -Math.PI / 2;
  }

  light({ shadow, lines, lineOpacity }: Ambience): void {
    this.shadow.opacity = shadow;
    this.lines.uniforms.colour.value.set(lines);
    this.lines.uniforms.opacity.value = lineOpacity;
  }

  /** Cells are a power of ten of the scene's unit, near a tenth of its size. */
  fit(centre: Vector3, height: number, radius: number): void {
    const extent = 2 * EXTENT_RADII * radius;
    const cell = 10 ** Math.round(Math.log10(radius / 8));
    this.position.set(centre.x, height, centre.z);
    this.scale.setScalar(extent);
    this.lines.uniforms.cells.value = extent / cell;
  }
}
