import {
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  FrontSide,
  type Ray,
  Triangle,
  Vector3,
  type Vector4,
} from 'three';
import { MeshBVH } from 'three-mesh-bvh';

/** A place on a surface. */
export interface Place {
  triangle: number;
  /** Shares of the triangle's three corners: 0…1, sum 1. */
  barycentric: readonly [number, number, number];
}

/** A place on a surface that a ray meets. */
export interface Picked extends Place {
  /** From where the ray begins, in radii of the frame. */
  distance: number;
}

/** Finds which of very many triangles a ray meets first, by a tree of their boxes. */
export class PickTree {
  #tree: MeshBVH;
  #corners: Float32Array;

  /** @param corners nine numbers a triangle */
  constructor(corners: Float32Array) {
    const geometry = new BufferGeometry().setAttribute('position', new BufferAttribute(corners, 3));
    this.#corners = corners;
    // Indirect: the triangles are drawn from the same array, so they must stay in their order.
    this.#tree = new MeshBVH(geometry, { indirect: true });
  }

  /**
   * The first triangle that a ray meets.
   *
   * @param doubleSided whether a triangle is met from behind too
   * @param clipPlane only what lies where x, y, z, 1 times these four numbers add up to 0 or more is there to be met
   */
  first(ray: Ray, doubleSided: boolean, clipPlane: Vector4): Picked | null {
    const [near, far] = keptPart(ray, clipPlane);
    if (near >= far) return null;
    const hit = this.#tree.raycastFirst(ray, doubleSided ? DoubleSide : FrontSide, near, far);
    const triangle = hit?.faceIndex;
    if (!hit || triangle === undefined || triangle === null) return null;
    return { triangle, barycentric: this.#shares(triangle, hit.point), distance: hit.distance };
  }

  #shares(triangle: number, point: Vector3): [number, number, number] {
    const corner = (index: number) => new Vector3().fromArray(this.#corners, 9 * triangle + 3 * index);
    const shares = Triangle.getBarycoord(point, corner(0), corner(1), corner(2), new Vector3());
    // A triangle without area has no shares; its first corner is a place in it.
    if (!shares) return [1, 0, 0];
    // A point that was met may lie outside by rounding.
    const kept = shares.toArray().map((share) => Math.max(0, share));
    const sum = kept[0] + kept[1] + kept[2];
    return [kept[0] / sum, kept[1] / sum, kept[2] / sum];
  }
}

/** From where to where along a ray the clipping plane leaves something. */
function keptPart({ origin, direction }: Ray, plane: Vector4): [near: number, far: number] {
  const height = plane.x * origin.x + plane.y * origin.y + plane.z * origin.z + plane.w;
  const slope = plane.x * direction.x + plane.y * direction.y + plane.z * direction.z;
  if (slope === 0) return height >= 0 ? [0, Infinity] : [0, 0];
  const crossing = -height / slope;
  return slope > 0 ? [Math.max(0, crossing), Infinity] : [0, crossing];
}
