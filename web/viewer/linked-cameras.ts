import { OrthographicCamera, PerspectiveCamera, Vector3 } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';

/** Vertical opening angle in degrees: narrow, so that perspective does not distort what is measured by eye. */
const fieldOfView = 30;
/** Half of what is seen at distance 1. */
const spread = Math.tan((fieldOfView * Math.PI) / 360);
/** Where the first look comes from. */
const firstDirection = new Vector3(0.5, 0.4, 1).normalize();
/** Room around the surface, as a factor of its size. */
const margin = 1.08;
/** One press of a key: an angle in radians, a factor of distance, a distance in pixels. */
const keyTurn = Math.PI / 24;
const keyZoom = 0.87;
const keyPan = 32;
/** So far from its target an orthographic camera stands that nothing lies behind it. */
const farAway = 60;

export type Projection = 'perspective' | 'orthographic';

/** The six sides from which one looks along an axis. */
export const viewDirections = {
  '+x': [1, 0, 0],
  '-x': [-1, 0, 0],
  '+y': [0, 1, 0],
  '-y': [0, -1, 0],
  '+z': [0, 0, 1],
  '-z': [0, 0, -1],
} as const;
export type ViewDirection = keyof typeof viewDirections;

/** Where a camera stands and what it looks at, in the frame of the surfaces: x, y, z each. */
export interface CameraPlace {
  position: readonly [number, number, number];
  target: readonly [number, number, number];
}

/** Significant digits of a place as text, and decimals: beyond what can be seen. */
const placeDigits = 4;
const placeDecimals = 6;

/** A place as text: "1.9 1.5 3.8 / 0 0 0", where the camera stands and what it looks at. */
export function placeText({ position, target }: CameraPlace): string {
  const rounded = (part: number) => Number(Number(part.toPrecision(placeDigits)).toFixed(placeDecimals));
  const text = (point: readonly number[]) => point.map(rounded).join(' ');
  return `${text(position)} / ${text(target)}`;
}

/** The place that a text states; null where it states none. */
export function parsePlace(text: string): CameraPlace | null {
  const [position, target, ...more] = text.split('/').map((part) => part.trim().split(/\s+/).map(Number));
  const isPoint = (point?: number[]) => point?.length === 3 && point.every(Number.isFinite);
  if (!isPoint(position) || !isPoint(target) || more.length > 0) return null;
  return { position, target } as unknown as CameraPlace;
}

/** Places as text, one a camera, where not all share one: "1.9 1.5 3.8 / 0 0 0; 0 0 4 / 0 0 0". */
export function placesText(places: CameraPlace[]): string {
  return places.map(placeText).join('; ');
}

/** The places that a text states; null where it does not. */
export function parsePlaces(text: string): CameraPlace[] | null {
  const places = text.split(';').map(parsePlace);
  return places.every((place) => place !== null) ? places : null;
}

/** Controls move a camera in perspective; one in parallel that shows the same size at the target follows it. */
interface Seat {
  perspective: PerspectiveCamera;
  orthographic: OrthographicCamera;
  controls: OrbitControls;
}

/** One camera a pane. While linked, whatever one of them does the others do too. */
export class LinkedCameras {
  #seats: Seat[];
  #linked = true;
  #projection: Projection = 'perspective';
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

  /** The camera that a pane is drawn with. */
  camera(pane: number): PerspectiveCamera | OrthographicCamera {
    const { perspective, orthographic } = this.#seats[pane];
    return this.#projection === 'perspective' ? perspective : orthographic;
  }

  get linked(): boolean {
    return this.#linked;
  }

  /** Linking again brings the others to where the first camera stands. */
  set linked(linked: boolean) {
    this.#linked = linked;
    if (linked) this.#follow(this.#seats[0]);
  }

  get projection(): Projection {
    return this.#projection;
  }

  set projection(projection: Projection) {
    this.#projection = projection;
    this.#changed();
  }

  /** Whether the view is the fitted one: it stays so when panes change their shape. */
  get fitted(): boolean {
    return this.#fitted;
  }

  place(pane: number): CameraPlace {
    const { perspective, controls } = this.#seats[pane];
    return { position: perspective.position.toArray(), target: controls.target.toArray() };
  }

  /** Puts the camera of a pane somewhere, and with it those that are linked. */
  setPlace(pane: number, { position, target }: CameraPlace): void {
    const { perspective, controls } = this.#seats[pane];
    perspective.position.set(...position);
    controls.target.set(...target);
    controls.update();
  }

  /** Brings the whole unit sphere into every view, seen from the first direction. */
  fit(): void {
    this.#fitFrom(firstDirection);
    this.#fitted = true;
    this.#changed();
  }

  /** Brings the whole unit sphere into every view, seen along an axis: from its positive or its negative end. */
  lookFrom(direction: ViewDirection): void {
    this.#fitFrom(new Vector3(...viewDirections[direction]));
    this.#fitted = false;
    this.#changed();
  }

  /** Turns the camera of a pane around its target until it looks against this direction. */
  turnTo(pane: number, direction: readonly [number, number, number]): void {
    const { position, target } = this.place(pane);
    const distance = new Vector3(...position).distanceTo(new Vector3(...target));
    const from = new Vector3(...direction).normalize().multiplyScalar(distance);
    this.setPlace(pane, { position: from.add(new Vector3(...target)).toArray(), target });
  }

  /** Width / height of each pane. What was fitted into view stays so. */
  setAspects(aspects: number[]): void {
    aspects.forEach((aspect, pane) => {
      const { perspective } = this.#seats[pane];
      perspective.aspect = aspect;
      perspective.updateProjectionMatrix();
      this.#alignOrthographic(this.#seats[pane]);
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
    const perspective = new PerspectiveCamera(fieldOfView, 1, 0.01, 100);
    const orthographic = new OrthographicCamera(-1, 1, 1, -1, 0.01, 2 * farAway);
    const controls = new OrbitControls(perspective, pane);
    controls.minDistance = 0.05;
    controls.maxDistance = 50;
    const seat = { perspective, orthographic, controls };
    controls.addEventListener('change', () => this.#moved(seat));
    return seat;
  }

  #fitFrom(direction: Vector3): void {
    this.#moving = true;
    for (const seat of this.#seats) {
      const { perspective, controls } = seat;
      const halfAngle = Math.atan(spread * Math.min(1, perspective.aspect));
      controls.target.set(0, 0, 0);
      perspective.position.copy(direction).multiplyScalar(margin / Math.sin(halfAngle));
      controls.update();
      this.#alignOrthographic(seat);
    }
    this.#moving = false;
  }

  #moved(seat: Seat): void {
    if (this.#moving) return;
    this.#fitted = false;
    this.#alignOrthographic(seat);
    if (this.#linked) this.#follow(seat);
    this.#changed();
  }

  #follow(leader: Seat): void {
    this.#moving = true;
    for (const seat of this.#seats) {
      if (seat === leader) continue;
      seat.perspective.position.copy(leader.perspective.position);
      seat.controls.target.copy(leader.controls.target);
      seat.controls.update();
      this.#alignOrthographic(seat);
    }
    this.#moving = false;
    this.#changed();
  }

  /** The same direction, and the same size of what is at the target. */
  #alignOrthographic({ perspective, orthographic, controls }: Seat): void {
    const toCamera = perspective.position.clone().sub(controls.target);
    const half = spread * toCamera.length();
    orthographic.top = half;
    orthographic.bottom = -half;
    orthographic.right = half * perspective.aspect;
    orthographic.left = -orthographic.right;
    orthographic.position.copy(toCamera).setLength(farAway).add(controls.target);
    orthographic.quaternion.copy(perspective.quaternion);
    orthographic.updateProjectionMatrix();
  }
}
