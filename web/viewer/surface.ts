import {
  BufferAttribute,
  BufferGeometry,
  DataTexture,
  DoubleSide,
  FrontSide,
  LinearFilter,
  Mesh,
  type RawShaderMaterial,
  RGBAFormat,
  Scene,
  Sphere,
  Vector3,
  type Vector4,
} from 'three';
import type { Frame } from './frame.ts';
import { type Look, planeInFrame } from './look.ts';
import { type LookupUniforms, lookupMaterial, type ShownColour } from './lookup-material.ts';
import type { MorphArrays } from './morph-corners.ts';
import { Outline } from './outline.ts';
import type { SurfaceArrays } from './surface-arrays.ts';

/** How places become colours. */
export interface Lookup {
  /** Colours from place 0 to place 1: red, green, blue, alpha bytes of each. */
  table: Uint8Array;
  /** Whether a place above 1 is to be marked, or takes the end of the map. */
  markAbove: boolean;
  above: ShownColour;
  /** Marks places below 0; without it they take the beginning of the map. */
  below?: ShownColour;
  missing: ShownColour;
}

/** An end of a morph, with the place in the map of each of its corners. */
export interface DrawnEnd {
  arrays: MorphArrays;
  places: Float32Array;
}

/** Lines over a surface: shapes in space, which shine through it, and borders on it. */
export type OutlineKind = 'shapes' | 'borders';

/** One surface in a scene of its own, with the memory that it holds on the graphics card. */
export class Surface {
  readonly scene = new Scene();
  #uniforms: LookupUniforms = {
    map: { value: null },
    belowColour: { value: [0, 0, 1] },
    aboveColour: { value: [1, 0, 1] },
    missingColour: { value: [0.5, 0.5, 0.5] },
    markBelow: { value: false },
    markAbove: { value: false },
    edges: { value: false },
    share: { value: 0 },
    flatShading: { value: false },
    clipPlane: { value: planeInFrame(null, { centre: [0, 0, 0], radius: 1 }) },
  };
  #material: RawShaderMaterial = lookupMaterial(this.#uniforms);
  #morphing: RawShaderMaterial = lookupMaterial(this.#uniforms, { MORPH: true });
  #mesh: Mesh<BufferGeometry, RawShaderMaterial> | null = null;
  readonly #outlines = { shapes: new Outline(true), borders: new Outline(false) };

  constructor() {
    for (const { object } of Object.values(this.#outlines)) this.scene.add(object);
  }

  /** Replaces lines over it; `segments` in the unit of the mesh, six numbers each. */
  outline(kind: OutlineKind, segments: Float64Array, frame: Frame): void {
    this.#outlines[kind].draw(segments, frame);
    if (kind === 'shapes') return;
    for (const material of [this.#material, this.#morphing]) {
      // Surfaces give way to lines on them.
      material.polygonOffset = segments.length > 0;
      material.polygonOffsetFactor = material.polygonOffsetUnits = 1;
    }
  }

  /** Replaces what is drawn; nothing where `arrays` is null. `places` has one number a corner. */
  draw(arrays: SurfaceArrays | null, places: Float32Array): void {
    this.#remove();
    if (arrays) this.#add(geometryOf(arrays, places), this.#material);
  }

  /** Replaces what is drawn by a morph, of which `share` says how far it is. The two ends have the same triangles. */
  drawMorph(finer: DrawnEnd, coarser: DrawnEnd): void {
    this.#remove();
    const geometry = geometryOf(finer.arrays, finer.places);
    geometry.setAttribute('face', new BufferAttribute(finer.arrays.faces, 3, true));
    geometry.setAttribute('within', new BufferAttribute(finer.arrays.within, 3, true));
    geometry.setAttribute('coarserPosition', new BufferAttribute(coarser.arrays.corners, 3));
    geometry.setAttribute('coarserNormal', new BufferAttribute(coarser.arrays.normals, 3));
    geometry.setAttribute('coarserPlace', new BufferAttribute(coarser.places, 1));
    geometry.setAttribute('coarserFace', new BufferAttribute(coarser.arrays.faces, 3, true));
    geometry.setAttribute('coarserWithin', new BufferAttribute(coarser.arrays.within, 3, true));
    this.#add(geometry, this.#morphing);
  }

  /** How far a morph is on its way to the coarser level, 0…1. */
  set share(share: number) {
    this.#uniforms.share.value = share;
  }

  /** Shows other places on the same triangles; of a morph those of both ends. */
  recolour(places: Float32Array, coarserPlaces?: Float32Array): void {
    this.#replace('place', places);
    if (coarserPlaces) this.#replace('coarserPlace', coarserPlaces);
  }

  set lookup({ table, markAbove, above, below, missing }: Lookup) {
    this.#uniforms.map.value?.dispose();
    const texture = new DataTexture(table, table.length / 4, 1, RGBAFormat);
    texture.magFilter = LinearFilter;
    texture.minFilter = LinearFilter;
    texture.needsUpdate = true;
    this.#uniforms.map.value = texture;
    this.#uniforms.markAbove.value = markAbove;
    this.#uniforms.aboveColour.value = above;
    this.#uniforms.markBelow.value = below !== undefined;
    if (below) this.#uniforms.belowColour.value = below;
    this.#uniforms.missingColour.value = missing;
  }

  /** How it is drawn; a clipping plane, in the frame, is given apart. */
  setLook({ edges, shading, doubleSided }: Look, clipPlane: Vector4): void {
    this.#uniforms.edges.value = edges;
    this.#uniforms.flatShading.value = shading === 'flat';
    this.#uniforms.clipPlane.value = clipPlane;
    for (const material of [this.#material, this.#morphing]) material.side = doubleSided ? DoubleSide : FrontSide;
  }

  /** Corners of the triangles that are drawn, nine numbers each, in the frame; null where nothing is. */
  get corners(): Float32Array | null {
    return (this.#mesh?.geometry.getAttribute('position').array as Float32Array | undefined) ?? null;
  }

  dispose(): void {
    this.#remove();
    this.#material.dispose();
    this.#morphing.dispose();
    this.#uniforms.map.value?.dispose();
    for (const outline of Object.values(this.#outlines)) outline.dispose();
  }

  #add(geometry: BufferGeometry, material: RawShaderMaterial): void {
    this.#mesh = new Mesh(geometry, material);
    this.scene.add(this.#mesh);
  }

  #replace(name: string, numbers: Float32Array): void {
    const attribute = this.#mesh?.geometry.getAttribute(name) as BufferAttribute | undefined;
    if (!attribute) return;
    attribute.array.set(numbers);
    attribute.needsUpdate = true;
  }

  #remove(): void {
    if (!this.#mesh) return;
    this.scene.remove(this.#mesh);
    this.#mesh.geometry.dispose();
    this.#mesh = null;
  }
}

function geometryOf(arrays: SurfaceArrays, places: Float32Array): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(arrays.corners, 3));
  geometry.setAttribute('normal', new BufferAttribute(arrays.normals, 3));
  geometry.setAttribute('place', new BufferAttribute(places, 1));
  geometry.boundingSphere = new Sphere(new Vector3(), 1);
  return geometry;
}
