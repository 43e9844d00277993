import { WebGLRenderer } from 'three';
import type { Frame } from './frame.ts';
import { LinkedCameras } from './linked-cameras.ts';
import type { MorphCorners } from './morph-corners.ts';
import { SurfacePreparer } from './prepare.ts';
import { MorphPreparer, type MorphSource } from './prepare-morph.ts';
import { type Lookup, Surface } from './surface.ts';
import type { Triangles } from './surface-arrays.ts';

/** Finer screens gain nothing that can be seen, and cost four times the fragments. */
const largestPixelRatio = 2;

/**
 * Several surfaces, each in its pane, drawn on one canvas that lies under all panes. It draws only when something changed.
 * Panes are counted from 0. The constructor throws where the browser offers no WebGL 2.
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
  #resizes = new ResizeObserver(() => this.#resize());
  #nextDraw = 0;

  constructor(canvas: HTMLCanvasElement, panes: HTMLElement[]) {
    super();
    this.#canvas = canvas;
    this.#panes = panes;
    this.#renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true });
    this.#renderer.setClearColor(0, 0);
    this.#renderer.setScissorTest(true);
    this.#surfaces = panes.map(() => new Surface());
    this.#wanted = panes.map(() => null);
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
    this.#requestDraw();
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
    this.#requestDraw();
  }

  /** How far the morph of a pane is on its way to the coarser surface, 0…1. */
  setShare(pane: number, share: number): void {
    this.#surfaces[pane].share = share;
    this.#requestDraw();
  }

  /** Other places on the surface that a pane shows; of a morph on both of its ends. */
  recolour(pane: number, places: Float32Array, coarserPlaces?: Float32Array): void {
    this.#surfaces[pane].recolour(places, coarserPlaces);
    this.#requestDraw();
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
    this.#requestDraw();
  }

  /** Flat shading with edges, or smooth shading. */
  set edges(shown: boolean) {
    for (const surface of this.#surfaces) surface.edges = shown;
    this.#requestDraw();
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

  #restored = (): void => this.#requestDraw();

  /** Draws before the next repaint, once, however often it is asked to. */
  #requestDraw(): void {
    this.#nextDraw ||= requestAnimationFrame(() => {
      this.#nextDraw = 0;
      this.#draw();
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
    const canvas = this.#canvas.getBoundingClientRect();
    this.#panes.forEach((pane, index) => {
      const { left, bottom, width, height } = pane.getBoundingClientRect();
      const [x, y] = [left - canvas.left, canvas.bottom - bottom];
      this.#renderer.setViewport(x, y, width, height);
      this.#renderer.setScissor(x, y, width, height);
      this.#renderer.render(this.#surfaces[index].scene, this.cameras.camera(index));
    });
    this.dispatchEvent(new Event('draw'));
  }
}
