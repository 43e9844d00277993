import type { Mesh } from '../../../wasm/types.ts';
import type { Keeping } from '../../session/constraints/keeping.ts';
import type { OpenSurface } from '../../session/reading/open-surface.ts';
import { regionBorders } from '../../surface/region-borders.ts';
import type { Frame } from '../../viewer/frame.ts';
import { ballSegments, boxSegments } from '../../viewer/outline.ts';
import type { Viewer } from '../../viewer/viewer.ts';

/** What lies over the surfaces: what is locked and where the bounds are finer, and the borders between regions. */
export class StageOutlines {
  #borders = new WeakMap<Int32Array, Float64Array>();

  /** On the original, whatever is asked for. */
  showKeeping(viewer: Viewer, { mesh, regions }: OpenSurface, keeping: Keeping, frame: Frame): void {
    const { lockBox, focusPoint } = keeping;
    const shapes = [...(lockBox ? boxSegments(lockBox) : []), ...(focusPoint ? ballSegments(focusPoint) : [])];
    viewer.outline(0, 'shapes', Float64Array.from(shapes), frame);
    const labels = keeping.regions === null ? undefined : regions?.get(keeping.regions);
    viewer.outline(0, 'borders', this.#bordersOf(mesh, labels), frame);
  }

  /** On the reduced surface; none where it is a morph. */
  showReduced(viewer: Viewer, mesh: Mesh | null, frame: Frame): void {
    viewer.outline(1, 'borders', mesh ? this.#bordersOf(mesh, mesh.regions) : new Float64Array(), frame);
  }

  #bordersOf(mesh: Mesh, labels: Int32Array | undefined): Float64Array {
    if (!labels) return new Float64Array();
    const borders = this.#borders.get(labels) ?? regionBorders(mesh, labels);
    this.#borders.set(labels, borders);
    return borders;
  }
}
