import { Ray, Vector3, Vector4 } from 'three';
import { describe, expect, test } from 'vitest';
import { planeInFrame } from '../../web/viewer/look.ts';
import { PickTree } from '../../web/viewer/pick-tree.ts';

const everything = new Vector4(0, 0, 0, 1);
const towards = new Vector3(0, 0, -1);
const rayAt = (x: number, y: number) => new Ray(new Vector3(x, y, 5), towards);

/** Two triangles one above the other, at z = 1 and z = 0, both seen from above. */
const corners = Float32Array.of(0, 0, 0, 4, 0, 0, 0, 4, 0, 0, 0, 1, 4, 0, 1, 0, 4, 1);

describe('picking', () => {
  const tree = new PickTree(corners);

  test('finds the nearest triangle, and the place in it', () => {
    const picked = tree.first(rayAt(1, 2), true, everything);
    expect(picked?.triangle).toBe(1);
    expect(picked?.distance).toBeCloseTo(4, 6);
    expect(picked?.barycentric.map((share) => share.toFixed(4))).toEqual(['0.2500', '0.2500', '0.5000']);
  });

  test('finds nothing beside the surface', () => expect(tree.first(rayAt(3, 3), true, everything)).toBeNull());

  test('meets a triangle from behind only where both sides are drawn', () => {
    const fromBelow = new Ray(new Vector3(1, 1, -5), new Vector3(0, 0, 1));
    expect(tree.first(fromBelow, true, everything)?.triangle).toBe(0);
    expect(tree.first(fromBelow, false, everything)).toBeNull();
  });

  test('passes through what is clipped, in the unit of the mesh', () => {
    const frame = { centre: [0, 0, 10], radius: 2 } as const;
    const at = (z: number, keeps: 'above' | 'below') =>
      tree.first(rayAt(1, 1), true, planeInFrame({ axis: 'z', at: z, keeps }, frame))?.triangle;
    // z = 0 and z = 1 in the frame are 10 and 12 in the mesh's unit.
    expect(at(11, 'below')).toBe(0);
    expect(at(11, 'above')).toBe(1);
    expect(at(9, 'below')).toBeUndefined();
    expect(at(13, 'above')).toBeUndefined();
  });

  test('does not change the order of the triangles that are drawn', () => {
    const side = 30;
    const many = Float32Array.from({ length: 9 * side * side }, (_, index) => {
      const [triangle, corner, axis] = [Math.floor(index / 9), Math.floor(index / 3) % 3, index % 3];
      const [column, row] = [(7 * triangle) % side, Math.floor(triangle / side)];
      return [column + (corner === 1 ? 0.9 : 0), row + (corner === 2 ? 0.9 : 0), 0][axis];
    });
    const before = many.slice();
    const large = new PickTree(many);
    for (let triangle = 0; triangle < side * side; triangle += 37) {
      const [x, y] = [many[9 * triangle] + 0.2, many[9 * triangle + 1] + 0.2];
      expect(large.first(rayAt(x, y), true, everything)?.triangle).toBe(triangle);
    }
    expect(many).toEqual(before);
  });
});
