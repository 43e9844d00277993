import {
  BufferGeometry,
  Float32BufferAttribute,
  GreaterDepth,
  Group,
  LineBasicMaterial,
  LineDashedMaterial,
  LineSegments,
} from 'three';
import type { Frame } from './frame.ts';

/** Of a dash and of the gap behind it, in radii of the frame. */
const dash = 0.02;

/** What surfaces hide of an outline is drawn so faint, in grey. */
const hiddenOpacity = 0.6;

type Place = readonly [number, number, number];

/** The edges of a box, six numbers each: the places of their two ends. */
export function boxSegments({ lowest, highest }: { lowest: Place; highest: Place }): Float64Array {
  const corner = (bits: number) => [0, 1, 2].map((axis) => ((bits >> axis) & 1 ? highest : lowest)[axis]);
  const edges = [0, 1, 2, 3, 4, 5, 6, 7].flatMap((from) =>
    [1, 2, 4].filter((axis) => !(from & axis)).flatMap((axis) => [...corner(from), ...corner(from | axis)]),
  );
  return Float64Array.from(edges);
}

/** A ball as three circles across the axes. */
export function ballSegments({ point, radius }: { point: Place; radius: number }): Float64Array {
  const steps = 48;
  const onCircle = (axis: number, step: number) => {
    const angle = (2 * Math.PI * step) / steps;
    const away = [0, Math.cos(angle), Math.sin(angle)];
    return point.map((centre, i) => centre + radius * away[(i + axis) % 3]);
  };
  const circle = (axis: number) =>
    Array.from({ length: steps }, (_, step) => [...onCircle(axis, step), ...onCircle(axis, step + 1)]).flat();
  return Float64Array.from([0, 1, 2].flatMap(circle));
}

/** Lines in space, to be seen on any ground: black with white dashes. */
export class Outline {
  readonly object = new Group();
  #geometry = new BufferGeometry();
  #materials = [
    new LineBasicMaterial({ color: 0 }),
    new LineDashedMaterial({ color: 0xffffff, dashSize: dash, gapSize: dash }),
  ];

  /** @param shining whether it is seen, faintly, through what hides it */
  constructor(shining: boolean) {
    if (shining) {
      this.#materials.push(
        new LineBasicMaterial({
          color: 0x808080,
          depthFunc: GreaterDepth,
          depthWrite: false,
          transparent: true,
          opacity: hiddenOpacity,
        }),
      );
    }
    this.object.visible = false;
    for (const material of this.#materials) this.object.add(new LineSegments(this.#geometry, material));
  }

  /** Replaces the lines; `segments` in the unit of the mesh, six numbers each. */
  draw(segments: Float64Array, { centre, radius }: Frame): void {
    const places = Float32Array.from(segments, (place, index) => (place - centre[index % 3]) / radius);
    this.object.visible = segments.length > 0;
    this.#geometry.dispose();
    this.#geometry = new BufferGeometry().setAttribute('position', new Float32BufferAttribute(places, 3));
    for (const lines of this.object.children as LineSegments[]) lines.geometry = this.#geometry;
    (this.object.children[0] as LineSegments).computeLineDistances();
  }

  dispose(): void {
    this.#geometry.dispose();
    for (const material of this.#materials) material.dispose();
  }
}
