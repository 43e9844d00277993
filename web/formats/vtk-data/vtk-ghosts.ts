import { gather } from '../cracks/weld.ts';
import { emptied, type Polygons } from '../faces/polygons.ts';
import type { Piece, PointArray } from './vtk-pieces.ts';
import type { VtkValues } from './vtk-values.ts';

/** What VTK calls the array of bits that say what a point or a cell is not, and what it called that before version 6.3. */
const [ghostName, ghostLevelName] = ['vtkGhostType', 'vtkGhostLevels'];

/** Cells that another piece has (1), that finer ones replace (8) and that are not shown (32); see vtkDataSetAttributes.h. */
const goneCell = 1 | 8 | 32;
/** Points that are not shown, and so no cell at them; one that another piece has (1) stays where a cell needs it. */
const [duplicatePoint, hiddenPoint] = [1, 2];

/** Whether an array says which points or cells are ghosts, and is no data of theirs. */
export function isGhostArray(name: string): boolean {
  return name === ghostName || name === ghostLevelName;
}

/** For each cell whether it is to be left out, from an array of that kind. */
function goneCells({ name, values }: Pick<PointArray, 'name' | 'values'>): (cell: number) => boolean {
  return name === ghostName ? (cell) => (values[cell] & goneCell) !== 0 : (cell) => values[cell] > 0;
}

/**
 * The piece without what its ghost arrays leave out: cells, and points that only such cells have. `ofCells` are those of its
 * cells: `before` that are no surface, then polygons, then strips. Polygons and strips that are gone have no corners.
 */
export function withoutGhosts(piece: Piece, ofCells: Pick<PointArray, 'name' | 'values'>[], before: number): Piece {
  const ofPoints = piece.arrays.filter(({ name }) => isGhostArray(name));
  if (ofCells.length + ofPoints.length === 0) return piece;
  const arrays = piece.arrays.filter(({ name }) => !isGhostArray(name));
  const goes = ofCells.map(goneCells);
  const flags = ofPoints.find(({ name }) => name === ghostName)?.values ?? new Float32Array();
  const [polygons, ghostPolygons] = shown(piece.polygons, (i) => goes.some((gone) => gone(before + i)), flags);
  const beforeStrips = before + piece.polygons.ends.length;
  const [strips, ghostStrips] = shown(piece.strips, (i) => goes.some((gone) => gone(beforeStrips + i)), flags);
  const kept = keptPoints(piece, [polygons, strips], ofPoints);
  const points = piece.position.values.length / 3;
  const ghosts = { polygons: ghostPolygons, strips: ghostStrips, points: points - kept.length };
  const rest = { ...piece, arrays, polygons, strips, ghosts };
  return ghosts.points === 0 ? rest : onlyPoints(rest, kept);
}

/** The polygons that are neither gone nor at a hidden point, and how many are one of both. */
function shown(polygons: Polygons, gone: (index: number) => boolean, flags: VtkValues): [Polygons, number] {
  const { corners, ends } = polygons;
  const isHidden = (corner: number) => (flags[corner] & hiddenPoint) !== 0;
  let ghosts = 0;
  const isGhost = (index: number) => {
    const start = index > 0 ? ends[index - 1] : 0;
    const isOne = gone(index) || (flags.length > 0 && corners.subarray(start, ends[index]).some(isHidden));
    if (isOne) ghosts++;
    return isOne;
  };
  return [emptied(polygons, isGhost), ghosts];
}

/** Points that cells have, or that neither a ghost has nor an array calls one. */
function keptPoints({ position, polygons, strips }: Piece, left: Polygons[], ofPoints: PointArray[]): Uint32Array {
  const points = position.values.length / 3;
  const isGhost = new Uint8Array(points);
  for (const { name, values } of ofPoints) {
    const mask = name === ghostName ? duplicatePoint | hiddenPoint : 0xff;
    for (let point = 0; point < points; point++) if ((values[point] & mask) !== 0) isGhost[point] = 1;
  }
  for (const { corners } of [polygons, strips]) for (const corner of corners) isGhost[corner] = 1;
  for (const { corners } of left) for (const corner of corners) isGhost[corner] = 0;
  return Uint32Array.from(isGhost.keys()).filter((point) => isGhost[point] === 0);
}

function onlyPoints(piece: Piece, kept: Uint32Array): Piece {
  const renumbered = new Uint32Array(piece.position.values.length / 3);
  for (const [to, from] of kept.entries()) renumbered[from] = to;
  const only = (array: PointArray) => ({ ...array, values: gather(array.values, array.components, kept) });
  const moved = ({ corners, ends }: Polygons) => ({ corners: corners.map((corner) => renumbered[corner]), ends });
  return {
    ...piece,
    position: only(piece.position),
    arrays: piece.arrays.map(only),
    polygons: moved(piece.polygons),
    strips: moved(piece.strips),
  };
}
