import { around, type Point } from './svg.ts';

/** The stars that the drawings share. */
export interface Star {
  candidate: Point;
  /** Counter-clockwise; of an open star from one end of the boundary to the other. */
  ring: Point[];
  open: boolean;
  /** New triangles by ring positions, the root first. */
  triangles: [number, number, number][];
  diagonals: [number, number][];
}

const lengths = [118, 105, 122, 112, 125, 104, 116];

export function closedStar(candidate: Point): Star {
  return {
    candidate,
    ring: lengths.map((length, i) =>
      around(candidate, length, (360 * i) / lengths.length + [8, -6, 4, 9, -7, 3, 0][i]),
    ),
    open: false,
    triangles: [
      [0, 2, 6],
      [0, 1, 2],
      [2, 5, 6],
      [2, 3, 5],
      [3, 4, 5],
    ],
    diagonals: [
      [0, 2],
      [2, 6],
      [2, 5],
      [3, 5],
    ],
  };
}

export function openStar(candidate: Point): Star {
  const degrees = [22, 58, 92, 130, 164];
  return {
    candidate,
    ring: degrees.map((degree, i) => around(candidate, [120, 128, 118, 130, 112][i], degree)),
    open: true,
    triangles: [
      [0, 3, 4],
      [0, 2, 3],
      [0, 1, 2],
    ],
    diagonals: [
      [0, 3],
      [0, 2],
    ],
  };
}
