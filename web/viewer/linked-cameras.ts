import { PerspectiveCamera, Vector3 } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';

/** Vertical opening angle in degrees: narrow, so that perspective does not distort what is measured by eye. */
const fieldOfView = 30;
/** Where the first look comes from. */
const firstDirection = new Vector3(0.5, 0.4, 1).normalize();
/** Room around the surface, as a factor of its size. */
const margin = 1.08;
/** One press of a key: an angle in radians, a factor of distance, a distance in pixels. */
const keyTurn = Math.PI / 24;
const keyZoom = 0.87;
const keyPan = 32;

interface Seat {
  camera: PerspectiveCamera;
  controls: OrbitControls;
}

/** One camera a pane. While linked, whatever one of them does the others do too. */
export class LinkedCameras {
  #seats: Seat[];
  #linked = true;
  /** Whether cameras move because this class moves them. */
  #moving = false;
  /** Whether nobody has moved a camera since everything was fitted into view. */
  #fitted = true;
  #changed: () => void;

  constructor(panes: HTMLElement[], changed: () => void) {
    this.#changed = changed;
    this.#seats = panes.map((pane) => this.#seat(pane));
    this.fit();
  }

  camera(pane: number): PerspectiveCamera {
    return this.#seats[pane].camera;
  }

  get linked(): boolean {
    return this.#linked;
  }

  /** Linking again brings the others to where the first camera stands. */
  set linked(linked: boolean) {
    this.#linked = linked;
    if (linked) this.#follow(this.#seats[0]);
  }

  /** Brings the whole unit sphere into every view, seen from the first direction. */
  fit(): void {
    this.#moving = true;
    for (const { camera, controls } of this.#seats) {
      const narrower = Math.min(1, camera.aspect);
      const halfAngle = Math.atan(Math.tan((fieldOfView * Math.PI) / 360) * narrower);
      controls.target.set(0, 0, 0);
      camera.position.copy(firstDirection).multiplyScalar(margin / Math.sin(halfAngle));
      controls.update();
    }
    this.#moving = false;
    this.#fitted = true;
    this.#changed();
  }

  /** Width / height of each pane. What was fitted into view stays so. */
  setAspects(aspects: number[]): void {
    aspects.forEach((aspect, pane) => {
      const { camera } = this.#seats[pane];
      camera.aspect = aspect;
      camera.updateProjectionMatrix();
    });
    if (this.#fitted) this.fit();
  }

  /** Arrow keys turn, with Shift they move, + and − zoom, 0 fits. Returns whether the key meant anything. */
  pressKey(pane: number, key: string, shift: boolean): boolean {
    const { controls } = this.#seats[pane];
    const actions: Record<string, () => void> = {
      ArrowLeft: () => (shift ? controls.pan(keyPan, 0) : controls.rotateLeft(keyTurn)),
      ArrowRight: () => (shift ? controls.pan(-keyPan, 0) : controls.rotateLeft(-keyTurn)),
      ArrowUp: () => (shift ? controls.pan(0, keyPan) : controls.rotateUp(keyTurn)),
      ArrowDown: () => (shift ? controls.pan(0, -keyPan) : controls.rotateUp(-keyTurn)),
      '+': () => controls.dollyIn(keyZoom),
      '=': () => controls.dollyIn(keyZoom),
      '-': () => controls.dollyOut(keyZoom),
      '0': () => this.fit(),
    };
    actions[key]?.();
    controls.update();
    return key in actions;
  }

  dispose(): void {
    for (const { controls } of this.#seats) controls.dispose();
  }

  #seat(pane: HTMLElement): Seat {
    // The surface lies within distance 1 of the origin; the near plane lets a viewer come close to it.
    const camera = new PerspectiveCamera(fieldOfView, 1, 0.01, 100);
    const controls = new OrbitControls(camera, pane);
    controls.minDistance = 0.05;
    controls.maxDistance = 50;
    const seat = { camera, controls };
    controls.addEventListener('change', () => this.#moved(seat));
    return seat;
  }

  #moved(seat: Seat): void {
    if (this.#moving) return;
    this.#fitted = false;
    if (this.#linked) this.#follow(seat);
    this.#changed();
  }

  #follow(leader: Seat): void {
    this.#moving = true;
    for (const seat of this.#seats) {
      if (seat === leader) continue;
      seat.camera.position.copy(leader.camera.position);
      seat.controls.target.copy(leader.controls.target);
      seat.controls.update();
    }
    this.#moving = false;
    this.#changed();
  }
}
