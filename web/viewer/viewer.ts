import { Raycaster, Vector2, Vector3, type Vector4, WebGLRenderer } from 'three';
import type { Frame, Triangles } from './frame.ts';
import { LinkedCameras } from './linked-cameras.ts';
import { type Look, plainLook, planeInFrame } from './look.ts';
import type { MorphCorners } from './morph-corners.ts';
import { type Picked, PickTree } from './pick-tree.ts';
import { SurfacePreparer } from './prepare.ts';
import { MorphPreparer, type MorphSource } from './prepare-morph.ts';
import { type Lookup, type OutlineKind, Surface } from './surface.ts';

/** Finer screens gain nothing that can be seen, and cost four times the fragments. */
const largestPixelRatio = 2;

/** How close to a point what covers it may lie, in radii of the frame: the point is on a surface itself. */
const coverTolerance = 2e-3;

/** Where a point of a surface is in its pane. */
export interface ScreenPlace {
  /** In CSS pixels from the pane's left and upper edge. */
  x: number;
  y: number;
  /** Whether another part of the surface, or the clipping plane, hides it. */
  hidden: boolean;
}

/**
 * Several surfaces, each in its pane, drawn on one canvas that lies under all panes. It draws only when something changed, and
 * of the panes only those that did: a large surface does not hold up a small one beside it.
 * Panes are counted from 0; one without size is not drawn. The constructor throws where the browser offers no WebGL 2.
 *
 * @fires draw when the picture has changed: what lies over it may follow
 */
export class Viewer extends EventTarget {
  readonly cameras: LinkedCameras;
  #canvas: HTMLCanvasElement;
  #panes: HTMLElement[];
  #renderer: WebGLRenderer;
  #surfaces: Surface[];
  #preparer = new SurfacePreparer();
  #morphPreparer = new MorphPreparer();
  /** What each pane was last asked to show. */
  #wanted: (Triangles | MorphSource | null)[];
  /** For picking; made when it is first asked for, and dropped with the surface. */
  #pickTrees: (PickTree | null)[];
  #frame: Frame = { centre: [0, 0, 0], radius: 1 };
  #look = plainLook;
  #divider: number | null = null;
  #resizes = new ResizeObserver(() => this.#resize());
  #nextDraw = 0;
  /** The panes to be drawn next. */
  #changed = new Set<number>();

  constructor(canvas: HTMLCanvasElement, panes: HTMLElement[]) {
    super();
    this.#canvas = canvas;
    this.#panes = panes;
    this.#renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true, preserveDrawingBuffer: true });
    this.#prepareContext();
    this.#surfaces = panes.map(() => new Surface());
    this.#wanted = panes.map(() => null);
    this.#pickTrees = panes.map(() => null);
    this.cameras = new LinkedCameras(panes, () => this.#requestDraw());
    canvas.addEventListener('webglcontextrestored', this.#restored);
    for (const element of [canvas, ...panes]) this.#resizes.observe(element);
  }

  /**
   * Replaces what a pane shows, as soon as it is ready to be drawn and unless something newer was asked for meanwhile.
   *
   * @param surface null empties the pane
   * @param places called when the surface is drawn: the place in the look-up table of each triangle corner
   */
  async show(pane: number, surface: Triangles | null, frame: Frame, places: () => Float32Array): Promise<void> {
    this.#wanted[pane] = surface;
    const arrays = surface && (await this.#preparer.prepare(surface, frame));
    if (this.#wanted[pane] !== surface) return;
    this.#surfaces[pane].draw(arrays, places());
    this.#placed(pane, frame);
  }

  /**
   * Replaces what a pane shows by a morph between two surfaces, as soon as it is ready to be drawn and unless something
   * newer was asked for meanwhile.
   *
   * @param places called when it is drawn, with its corners on the finer and on the coarser surface: the place in the
   * look-up table of each of them
   */
  async showMorph(
    pane: number,
    morph: MorphSource,
    frame: Frame,
    places: (finer: MorphCorners, coarser: MorphCorners) => readonly [finer: Float32Array, coarser: Float32Array],
  ): Promise<void> {
    this.#wanted[pane] = morph;
    const { finer, coarser } = await this.#morphPreparer.prepare(morph, frame);
    if (this.#wanted[pane] !== morph) return;
    const [finerPlaces, coarserPlaces] = places(finer.at, coarser.at);
    this.#surfaces[pane].drawMorph(
      { arrays: finer.arrays, places: finerPlaces },
      { arrays: coarser.arrays, places: coarserPlaces },
    );
    this.#placed(pane, frame);
  }

  /** How far the morph of a pane is on its way to the coarser surface, 0…1. */
  setShare(pane: number, share: number): void {
    this.#surfaces[pane].share = share;
    this.#requestDraw([pane]);
  }

  /** Other places on the surface that a pane shows; of a morph on both of its ends. */
  recolour(pane: number, places: Float32Array, coarserPlaces?: Float32Array): void {
    this.#surfaces[pane].recolour(places, coarserPlaces);
    this.#requestDraw([pane]);
  }

  /** How many CSS pixels the frame's radius spans where the surface of a pane is nearest; infinite inside of it. */
  pixelsPerRadius(pane: number): number {
    const camera = this.cameras.camera(pane);
    const elements = camera.projectionMatrix.elements;
    const parallel = elements[15] === 1;
    const distance = parallel ? 1 : camera.position.length() - 1;
    return distance > 0 ? (elements[5] * this.#panes[pane].clientHeight) / 2 / distance : Infinity;
  }

  /** How the places of a pane become colours. */
  setLookup(pane: number, lookup: Lookup): void {
    this.#surfaces[pane].lookup = lookup;
    this.#requestDraw([pane]);
  }

  /** Lines over the surface of a pane; `segments` in the unit of the mesh, six numbers each: the places of their ends. */
  outline(pane: number, kind: OutlineKind, segments: Float64Array, frame: Frame): void {
    this.#surfaces[pane].outline(kind, segments, frame);
    this.#requestDraw([pane]);
  }

  get look(): Look {
    return this.#look;
  }

  set look(look: Look) {
    this.#look = look;
    this.#applyLook();
  }

  /**
   * Where panes lie over each other, the share of their width, 0…1, at which the first one ends and the others begin; null
   * where every pane shows all of its surface.
   */
  set divider(share: number | null) {
    this.#divider = share;
    this.#requestDraw();
  }

  /** The place on the surface of a pane that is seen at a point of the window; null where there is none. */
  pick(pane: number, clientX: number, clientY: number): Picked | null {
    const { left, top, width, height } = this.#panes[pane].getBoundingClientRect();
    const across = new Vector2((2 * (clientX - left)) / width - 1, 1 - (2 * (clientY - top)) / height);
    const raycaster = new Raycaster();
    raycaster.setFromCamera(across, this.#camera(pane));
    return this.#pickTree(pane)?.first(raycaster.ray, this.#look.doubleSided, this.#clipPlane()) ?? null;
  }

  /** Where a point, in the mesh's unit, is seen in a pane; null where it is outside. */
  screenPlace(pane: number, point: readonly number[]): ScreenPlace | null {
    const { clientWidth, clientHeight } = this.#panes[pane];
    const { centre, radius } = this.#frame;
    const inFrame = new Vector3(...[0, 1, 2].map((axis) => (point[axis] - centre[axis]) / radius));
    const { x, y, z } = inFrame.clone().project(this.#camera(pane));
    if (Math.max(Math.abs(x), Math.abs(y), Math.abs(z)) > 1) return null;
    return {
      x: ((1 + x) / 2) * clientWidth,
      y: ((1 - y) / 2) * clientHeight,
      hidden: this.#isHidden(pane, inFrame, new Vector2(x, y)),
    };
  }

  /** What is seen at this moment, as an image of the given type; the background stays transparent. */
  picture(type = 'image/png'): Promise<Blob | null> {
    this.#draw();
    return new Promise((resolve) => this.#canvas.toBlob(resolve, type));
  }

  /** Gives back all memory; the viewer is of no use afterwards. */
  dispose(): void {
    cancelAnimationFrame(this.#nextDraw);
    this.#canvas.removeEventListener('webglcontextrestored', this.#restored);
    this.#wanted.fill(null);
    this.#resizes.disconnect();
    this.#preparer.dispose();
    this.#morphPreparer.dispose();
    this.cameras.dispose();
    for (const surface of this.#surfaces) surface.dispose();
    this.#renderer.dispose();
  }

  /** What a pane shows is another surface. */
  #placed(pane: number, frame: Frame): void {
    const moved = frame !== this.#frame;
    this.#pickTrees[pane] = null;
    this.#frame = frame;
    if (moved) this.#applyLook();
    else this.#requestDraw([pane]);
  }

  #applyLook(): void {
    for (const surface of this.#surfaces) surface.setLook(this.#look, this.#clipPlane());
    this.#requestDraw();
  }

  #clipPlane(): Vector4 {
    return planeInFrame(this.#look.clip, this.#frame);
  }

  #camera(pane: number) {
    const camera = this.cameras.camera(pane);
    camera.updateMatrixWorld();
    return camera;
  }

  #pickTree(pane: number): PickTree | null {
    const { corners } = this.#surfaces[pane];
    if (corners) this.#pickTrees[pane] ??= new PickTree(corners);
    return this.#pickTrees[pane];
  }

  #isHidden(pane: number, point: Vector3, onScreen: Vector2): boolean {
    const plane = this.#clipPlane();
    if (plane.x * point.x + plane.y * point.y + plane.z * point.z + plane.w < -coverTolerance) return true;
    const raycaster = new Raycaster();
    raycaster.setFromCamera(onScreen, this.#camera(pane));
    const seen = this.#pickTree(pane)?.first(raycaster.ray, this.#look.doubleSided, plane);
    return (
      seen !== undefined && seen !== null && seen.distance < raycaster.ray.origin.distanceTo(point) - coverTolerance
    );
  }

  /** A graphics card that was lost comes back with nothing of what it was told; surfaces are sent to it anew when drawn. */
  #restored = (): void => {
    this.#prepareContext();
    this.#requestDraw();
  };

  #prepareContext(): void {
    this.#renderer.setClearColor(0, 0);
    this.#renderer.setScissorTest(true);
  }

  /** Draws panes, all unless some are named, before the next repaint, once, however often it is asked to. */
  #requestDraw(panes: Iterable<number> = this.#panes.keys()): void {
    for (const pane of panes) this.#changed.add(pane);
    this.#nextDraw ||= requestAnimationFrame(() => {
      this.#nextDraw = 0;
      this.#drawPanes(this.#changed);
    });
  }

  #resize(): void {
    const { clientWidth, clientHeight } = this.#canvas;
    if (clientWidth === 0 || clientHeight === 0) return;
    this.#renderer.setPixelRatio(Math.min(devicePixelRatio, largestPixelRatio));
    this.#renderer.setSize(clientWidth, clientHeight, false);
    this.cameras.setAspects(this.#panes.map((pane) => pane.clientWidth / pane.clientHeight || 1));
    // A canvas that changes size loses its picture: waiting for the next repaint would flash.
    this.#draw();
  }

  #draw(): void {
    const { width, height } = this.#canvas.getBoundingClientRect();
    this.#renderer.setScissor(0, 0, width, height);
    this.#renderer.clear();
    this.#drawPanes(new Set(this.#panes.keys()));
  }

  /** What is drawn of others stays. */
  #drawPanes(panes: ReadonlySet<number>): void {
    const canvas = this.#canvas.getBoundingClientRect();
    for (const index of panes) {
      const { left, bottom, width, height } = this.#panes[index].getBoundingClientRect();
      if (width === 0 || height === 0) continue;
      const [x, y] = [left - canvas.left, canvas.bottom - bottom];
      const [begin, end] = this.#shownOf(index, width);
      this.#renderer.setViewport(x, y, width, height);
      this.#renderer.setScissor(x + begin, y, end - begin, height);
      this.#renderer.render(this.#surfaces[index].scene, this.cameras.camera(index));
    }
    this.#changed.clear();
    this.dispatchEvent(new Event('draw'));
  }

  /** From where to where across a pane its surface is drawn. */
  #shownOf(pane: number, width: number): [begin: number, end: number] {
    if (this.#divider === null) return [0, width];
    const border = Math.round(this.#divider * width);
    return pane === 0 ? [0, border] : [border, width];
  }
}
