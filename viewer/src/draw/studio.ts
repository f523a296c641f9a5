/** The empty stage: camera, light and ground, drawn again only when something has changed. */

import {
  Box3,
  DirectionalLight,
  HemisphereLight,
  NeutralToneMapping,
  PCFShadowMap,
  PerspectiveCamera,
  PMREMGenerator,
  Scene,
  Sphere,
  Spherical,
  Vector3,
  WebGLRenderer,
  type Texture,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { RoomEnvironment } from 'three/addons/environments/RoomEnvironment.js';
import { SIDES } from '../scene/sides';
import type { Vector3 as Side } from '../scene/types';
import { CameraFlight } from './camera_flight';
import type { Ambience } from './colours';
import { Ground } from './ground';
import { StillCamera } from './still_camera';

const FIELD_OF_VIEW = 32;
/** Relative to the distance that shows everything. The ends of a walk may be cut off. */
const CLOSENESS = { standing: 0.95, walking: 0.66 };

/** Size of a close view, relative to the contacts that it shows. */
const SURROUNDINGS = { picture: 3, still: 1.25 };
/** Closest distance, relative to the whole scene. */
const NEAREST = 0.16;

const KEY_DIRECTION = new Vector3(0.75, 1.5, 0.55).normalize();
const RIM_DIRECTION = new Vector3(-0.9, 0.8, -0.7).normalize();

export class Studio {
  readonly scene = new Scene();
  readonly camera = new PerspectiveCamera(FIELD_OF_VIEW);
  readonly canvas: HTMLCanvasElement;
  readonly orbit: OrbitControls;
  private readonly renderer: WebGLRenderer;
  private readonly stills: StillCamera;
  private readonly sky = new HemisphereLight();
  private readonly key = new DirectionalLight(0xfff2e2);
  private readonly rim = new DirectionalLight(0xa9c4ff);
  private readonly ground = new Ground();
  private readonly whole = new Sphere();
  private distance = 1;
  /** Side from which the whole scene is seen. */
  private side = new Vector3(...SIDES[0]);
  /** Nobody has moved the camera yet. */
  private isUntouched = true;
  private flight: CameraFlight | null = null;
  private isStale = true;

  constructor(private readonly place: HTMLElement) {
    this.renderer = new WebGLRenderer({ antialias: true, alpha: true });
    this.renderer.toneMapping = NeutralToneMapping;
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.type = PCFShadowMap;
    this.stills = new StillCamera(this.renderer);
    this.canvas = this.renderer.domElement;
    place.append(this.canvas);

    this.orbit = new OrbitControls(this.camera, this.canvas);
    this.orbit.enableDamping = true;
    this.orbit.dampingFactor = 0.12;
    this.orbit.addEventListener('change', () => this.redraw());
    this.orbit.addEventListener('start', () => this.takeCamera());

    this.scene.environment = makeSurroundings(this.renderer);

    this.key.castShadow = true;
    this.key.shadow.mapSize.set(2048, 2048);
    this.key.shadow.radius = 3;
    this.scene.add(this.sky, this.key, this.key.target, this.rim, this.rim.target, this.ground);
    new ResizeObserver(() => this.resize()).observe(place);
    this.renderer.setAnimationLoop(() => this.draw());
  }

  redraw(): void {
    this.isStale = true;
  }

  light(ambience: Ambience): void {
    this.sky.color.set(ambience.sky);
    this.sky.groundColor.set(ambience.earth);
    this.sky.intensity = ambience.ambient;
    this.scene.environmentIntensity = ambience.surroundings;
    this.key.intensity = ambience.key;
    this.rim.intensity = ambience.rim;
    this.ground.light(ambience);
    this.redraw();
  }

  /** Camera, light and ground for what is in the box. */
  frame(box: Box3, kind: 'standing' | 'walking'): void {
    const { center, radius } = box.getBoundingSphere(this.whole);
    const distance = distanceOf(CLOSENESS[kind] * radius) / Math.min(1, this.camera.aspect);
    this.distance = distance;
    this.flight = null;
    this.isUntouched = true;
    this.side.set(...SIDES[0]);
    this.camera.position.copy(center).addScaledVector(this.side, distance);
    this.camera.near = distance / 200;
    this.camera.far = distance * 20;
    this.camera.updateProjectionMatrix();
    this.orbit.target.copy(center);
    this.orbit.update();
    this.aim(this.key, KEY_DIRECTION, center, radius);
    this.aim(this.rim, RIM_DIRECTION, center, radius);
    this.ground.fit(center, box.min.y, radius);
    this.redraw();
  }

  /** The camera flies to where it was at first. */
  seeWhole(): void {
    const { center } = this.whole;
    this.fly(center.clone().addScaledVector(this.side, this.distance), center.clone());
  }

  /** Shows the whole scene from this side; immediately if the user has not moved the camera. */
  turnTo(side: Side): void {
    this.side.set(...side);
    if (!this.isUntouched) return;
    this.seeWhole();
    this.isUntouched = true;
  }

  /** The camera flies to what is in the box; `choose` may take it to another side. */
  lookAt(box: Box3, choose: (present: Side) => Side): void {
    const present = this.camera.position.clone().sub(this.orbit.target).normalize();
    this.fly(...this.placeToSee(box, new Vector3(...choose(present.toArray()))));
  }

  /** Around what the camera looks at; radians. */
  turnCamera(right: number, up: number): void {
    const away = new Spherical().setFromVector3(
      this.camera.position.clone().sub(this.orbit.target),
    );
    away.theta += right;
    away.phi -= up;
    this.putCamera(new Vector3().setFromSpherical(away.makeSafe()));
  }

  /** Moves towards or away from the point that the camera looks at. */
  zoom(factor: number): void {
    this.putCamera(this.camera.position.clone().sub(this.orbit.target).divideScalar(factor));
  }

  /** The address of an image of what is in the box from a side of it, wherever the camera is. */
  photograph(box: Box3, from: Side): string {
    const camera = this.camera.clone();
    const [position, target] = this.placeToSee(box, new Vector3(...from), SURROUNDINGS.still);
    camera.position.copy(position);
    camera.lookAt(target);
    return this.stills.take(this.scene, camera);
  }

  /** Position and target of the camera. */
  private placeToSee(
    box: Box3,
    from: Vector3,
    surroundings = SURROUNDINGS.picture,
  ): [Vector3, Vector3] {
    const { center, radius } = box.getBoundingSphere(new Sphere());
    const distance = distanceOf(Math.max(surroundings * radius, NEAREST * this.whole.radius));
    const most = Math.min(distance, this.distance);
    return [center.clone().addScaledVector(from, most), center];
  }

  private takeCamera(): void {
    this.flight = null;
    this.isUntouched = false;
  }

  private fly(position: Vector3, target: Vector3): void {
    this.takeCamera();
    const from = { position: this.camera.position.clone(), target: this.orbit.target.clone() };
    this.flight = new CameraFlight(from, { position, target });
  }

  private putCamera(away: Vector3): void {
    this.takeCamera();
    this.camera.position.copy(this.orbit.target).add(away);
    this.redraw();
  }

  private aim(light: DirectionalLight, from: Vector3, centre: Vector3, radius: number): void {
    light.target.position.copy(centre);
    light.position.copy(centre).addScaledVector(from, 4 * radius);
    const reach = 1.6 * radius;
    Object.assign(light.shadow.camera, { left: -reach, right: reach, top: reach, bottom: -reach });
    Object.assign(light.shadow.camera, { near: radius, far: 8 * radius });
    light.shadow.camera.updateProjectionMatrix();
    light.shadow.normalBias = radius / 400;
  }

  private resize(): void {
    const { clientWidth, clientHeight } = this.place;
    if (clientWidth === 0 || clientHeight === 0) return;
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.renderer.setSize(clientWidth, clientHeight);
    this.camera.aspect = clientWidth / clientHeight;
    this.camera.updateProjectionMatrix();
    this.redraw();
  }

  private draw(): void {
    if (this.flight?.move(this.camera, this.orbit.target, performance.now())) this.flight = null;
    this.orbit.update();
    if (!this.isStale) return;
    this.isStale = false;
    this.renderer.render(this.scene, this.camera);
  }
}

/** Blurred environment that surfaces reflect. */
function makeSurroundings(renderer: WebGLRenderer): Texture {
  const generator = new PMREMGenerator(renderer);
  const room = new RoomEnvironment();
  const { texture } = generator.fromScene(room, 0.04);
  generator.dispose();
  room.dispose();
  return texture;
}

/** Returns the distance at which a ball of this radius fills the picture. */
function distanceOf(radius: number): number {
  return radius / Math.sin((FIELD_OF_VIEW * Math.PI) / 360);
}
