import { WebGLRenderer } from 'three';
import { LinkedCameras } from './linked-cameras.ts';
import { Surface } from './surface.ts';

/** Finer screens gain nothing that can be seen, and cost four times the fragments. */
const largestPixelRatio = 2;

/**
 * Several surfaces, each in its pane, drawn on one canvas that lies under all panes. It draws only when something changed.
 * Throws where the browser offers no WebGL 2.
 */
export class Viewer {
  readonly cameras: LinkedCameras;
  readonly surfaces: Surface[];
  #canvas: HTMLCanvasElement;
  #panes: HTMLElement[];
  #renderer: WebGLRenderer;
  #resizes = new ResizeObserver(() => this.#resize());
  #frame = 0;
  #fitted = false;

  constructor(canvas: HTMLCanvasElement, panes: HTMLElement[]) {
    this.#canvas = canvas;
    this.#panes = panes;
    this.#renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true });
    this.#renderer.setClearColor(0, 0);
    this.#renderer.setScissorTest(true);
    this.surfaces = panes.map(() => new Surface());
    this.cameras = new LinkedCameras(panes, () => this.requestDraw());
    canvas.addEventListener('webglcontextrestored', () => this.requestDraw());
    for (const element of [canvas, ...panes]) this.#resizes.observe(element);
  }

  /** Draws before the next repaint, once, however often it is asked to. */
  requestDraw(): void {
    this.#frame ||= requestAnimationFrame(() => {
      this.#frame = 0;
      this.#draw();
    });
  }

  dispose(): void {
    cancelAnimationFrame(this.#frame);
    this.#resizes.disconnect();
    this.cameras.dispose();
    for (const surface of this.surfaces) surface.dispose();
    this.#renderer.dispose();
  }

  #resize(): void {
    const { clientWidth, clientHeight } = this.#canvas;
    if (clientWidth === 0 || clientHeight === 0) return;
    this.#renderer.setPixelRatio(Math.min(devicePixelRatio, largestPixelRatio));
    this.#renderer.setSize(clientWidth, clientHeight, false);
    this.#panes.forEach((pane, index) => {
      this.cameras.setAspect(index, pane.clientWidth / pane.clientHeight || 1);
    });
    // How far a camera must stand back depends on the shape of its pane, which is only known now.
    if (!this.#fitted) this.cameras.fit();
    this.#fitted = true;
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
      this.#renderer.render(this.surfaces[index].scene, this.cameras.camera(index));
    });
  }
}
