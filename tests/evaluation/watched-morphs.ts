// Runs in a browser page: makes levels of a sample, leads through their morphs as the page does, and watches the pictures.

import { reduceLevels } from '../../wasm/index.ts';
import type { Levels, Mesh } from '../../wasm/types.ts';
import { colourTable } from '../../web/colour/colormaps.ts';
import { cornerPlaces, fieldOf, fieldRange } from '../../web/colour/field.ts';
import { readPly } from '../../web/formats/ply/read-ply.ts';
import { topologyOf } from '../../web/surface/topology.ts';
import { frameOf } from '../../web/viewer/frame.ts';
import { plainLook } from '../../web/viewer/look.ts';
import { carriedOver } from '../../web/viewer/morph-corners.ts';
import type { MorphSource } from '../../web/viewer/prepare-morph.ts';
import { Viewer } from '../../web/viewer/viewer.ts';
import { percents, type Seen, type WatchedStep } from './watched-steps.ts';

/** What of the map may be chosen by error; the rest is as the holes were laid out. */
export interface Freedom {
  optimizeVertexImages: boolean;
  optimizeEdgeCrossings: boolean;
}

/** The sides of the picture. */
const size = 500;
/** A colour that changes by more than this, in 1/255, changes visibly. */
const visible = 8;

/** @param frames how many pictures to take on each way, beside the first */
export async function watchMorphs(address: string, freedom: Freedom, frames: number): Promise<WatchedStep[]> {
  const { mesh } = readPly(new Uint8Array(await (await fetch(address)).arrayBuffer()));
  const levels = percents.map((percent) => ({
    position: { relative: percent / 100 },
    '*': { relative: (3 * percent) / 100 },
  }));
  const nested = await reduceLevels(mesh, { levels, morphs: true, ...freedom });
  const theatre = new Theatre(mesh);
  const steps: WatchedStep[] = [];
  for (const level of nested.levels.keys()) steps.push(await theatre.watch(nested, level, frames));
  theatre.close();
  return steps;
}

/** A viewer with one pane, whose calls are counted. */
class Theatre {
  readonly #mesh: Mesh;
  readonly #closed: boolean;
  readonly #canvas = document.createElement('canvas');
  readonly #pane = document.createElement('div');
  readonly #viewer: Viewer;
  readonly #counted = { calls: 0, vertices: 0, bytes: 0 };

  constructor(mesh: Mesh) {
    this.#mesh = mesh;
    this.#closed = topologyOf(mesh.triangles, mesh.position.length / 3).boundaryLoops === 0;
    for (const element of [this.#canvas, this.#pane]) {
      element.style.cssText = `position: absolute; inset: 0; width: ${size}px; height: ${size}px`;
      document.body.append(element);
    }
    this.#viewer = new Viewer(this.#canvas, [this.#pane]);
    this.#viewer.setLookup(0, {
      table: colourTable('viridis'),
      markAbove: false,
      above: [1, 0, 1],
      missing: [0.5, 0.5, 0.5],
    });
    this.#count(this.#canvas.getContext('webgl2') as WebGL2RenderingContext);
  }

  close(): void {
    this.#viewer.dispose();
    this.#canvas.remove();
    this.#pane.remove();
  }

  /** The way to a level from the one before. */
  async watch({ levels, morphs }: Levels, level: number, frames: number): Promise<WatchedStep> {
    const [finer, coarser] = [level > 0 ? levels[level - 1].mesh : this.#mesh, levels[level].mesh];
    const morph = morphs[level];
    this.#counted.bytes = 0;
    await this.#show(morph, finer, coarser);
    await this.#frame(0.25);
    const { bytes } = this.#counted;
    Object.assign(this.#counted, { calls: 0, vertices: 0 });
    await this.#frame(0.5);
    const { calls, vertices } = this.#counted;
    return {
      finer: finer.triangles.length / 3,
      coarser: coarser.triangles.length / 3,
      pieces: morph.triangles.length / 3,
      folded: morph.foldedTriangles,
      calls,
      vertices,
      bytes,
      seen: await this.#seen(frames),
    };
  }

  async #show(morph: Levels['morphs'][number], finer: Mesh, coarser: Mesh): Promise<void> {
    const source: MorphSource = {
      triangles: morph.triangles,
      finer: { end: morph.finer, surface: finer },
      coarser: { end: morph.coarser, surface: coarser },
    };
    await this.#viewer.showMorph(0, source, frameOf(this.#mesh), (...ends) => {
      const places = [finer, coarser].map((mesh, end) => carriedOver(this.#placesOf(mesh), 1, ends[end]));
      return [places[0], places[1]];
    });
  }

  /** The first variable that varies, as it is coloured on its range. */
  #placesOf(mesh: Mesh): Float32Array {
    const original = this.#mesh.variables.find(({ name }) => name === 'pressure') ?? this.#mesh.variables[0];
    const range = fieldRange(fieldOf(original, 0), this.#mesh.triangles);
    const variable = mesh.variables.find(({ name }) => name === original.name) ?? original;
    return cornerPlaces(fieldOf(variable, 0), mesh.triangles, range);
  }

  async #seen(frames: number): Promise<Seen> {
    const shares = Array.from({ length: frames + 1 }, (_, i) => i / frames);
    const whole = await this.#film(shares, true);
    const surface = pixels().filter((pixel) => whole.every((picture) => isSurface(picture, pixel)));
    const share: Share = (a, b) => surface.filter((pixel) => apart(a, b, pixel) > visible).length / surface.length;
    const changes = whole.slice(1).map((picture, i) => share(whole[i], picture));
    return {
      usual: median(changes),
      most: Math.max(...changes),
      detour: surface.reduce((sum, pixel) => sum + detourAt(whole, pixel), 0) / surface.length,
      backs: this.#closed ? backsSeen(whole, await this.#film(shares, false), share) : null,
    };
  }

  async #film(shares: number[], doubleSided: boolean): Promise<Picture[]> {
    this.#viewer.look = { ...plainLook, doubleSided };
    const film: Picture[] = [];
    for (const share of shares) film.push(await this.#frame(share));
    this.#viewer.look = plainLook;
    return film;
  }

  #frame(share: number): Promise<Picture> {
    const drawn = new Promise<Picture>((resolve) => {
      this.#viewer.addEventListener('draw', () => resolve(pictureOn(this.#canvas)), { once: true });
    });
    this.#viewer.setShare(0, share);
    return drawn;
  }

  #count(context: WebGL2RenderingContext): void {
    const counted = this.#counted;
    const { drawArrays, bufferData } = context;
    context.drawArrays = (mode, first, count) => {
      counted.calls++;
      counted.vertices += count;
      drawArrays.call(context, mode, first, count);
    };
    context.bufferData = ((...[target, data, usage]: [number, ArrayBufferView, number]) => {
      counted.bytes += data.byteLength;
      Reflect.apply(bufferData, context, [target, data, usage]);
    }) as typeof context.bufferData;
  }
}

/** Red, green, blue, alpha bytes, row by row. */
type Picture = Uint8ClampedArray;

/** The share of the surface's pixels that differ visibly. */
type Share = (a: Picture, b: Picture) => number;

function backsSeen(whole: Picture[], oneSided: Picture[], share: Share): Seen['backs'] {
  return {
    folds: Math.max(...whole.map((picture, i) => share(picture, oneSided[i]))),
    holes: Math.max(...whole.map((picture, i) => missing(picture, oneSided[i]))),
  };
}

/** What stands on a canvas in the moment in which it was drawn. */
function pictureOn(canvas: HTMLCanvasElement): Picture {
  const context = new OffscreenCanvas(size, size).getContext('2d') as OffscreenCanvasRenderingContext2D;
  context.drawImage(canvas, 0, 0, size, size);
  return context.getImageData(0, 0, size, size).data;
}

function pixels(): number[] {
  return Array.from({ length: size * size }, (_, pixel) => pixel);
}

function isSurface(picture: Picture, pixel: number): boolean {
  return picture[4 * pixel + 3] === 255;
}

function median(numbers: number[]): number {
  return numbers.toSorted((a, b) => a - b)[Math.floor(numbers.length / 2)];
}

function missing(whole: Picture, oneSided: Picture): number {
  return pixels().filter((pixel) => whole[4 * pixel + 3] > 0 && oneSided[4 * pixel + 3] === 0).length;
}

function apart(a: Picture, b: Picture, pixel: number): number {
  const at = 4 * pixel;
  return Math.max(...[at, at + 1, at + 2].map((part) => Math.abs(a[part] - b[part])));
}

/** How much longer the way of a pixel's colour is than its ends are apart, part by part. */
function detourAt(film: Picture[], pixel: number): number {
  let sum = 0;
  for (const part of [4 * pixel, 4 * pixel + 1, 4 * pixel + 2]) {
    for (let i = 1; i < film.length; i++) sum += Math.abs(film[i][part] - film[i - 1][part]);
    sum -= Math.abs((film.at(-1) as Picture)[part] - film[0][part]);
  }
  return sum / 3;
}
