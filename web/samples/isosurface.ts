import vtkDataArray from '@kitware/vtk.js/Common/Core/DataArray.js';
import vtkImageData from '@kitware/vtk.js/Common/DataModel/ImageData.js';
import vtkImageMarchingCubes from '@kitware/vtk.js/Filters/General/ImageMarchingCubes.js';

import type { Mesh } from '../../wasm/types.ts';
import type { Volume } from './simulate.ts';

/**
 * The surface keeps this fraction of a grid edge away from the edge's ends: nearer to them it would have slivers, and
 * on the very end points would coincide.
 */
const distanceFromEnds = 0.01;

/** Where a point of the surface lies: on the edge of the grid from `low` to `high`, the fraction `t` of the way. */
interface GridPoint {
  /** Numbers of the two values, counted as in the volume. */
  low: number;
  high: number;
  t: number;
  /** Place in the grid, in cells from the first value. */
  place: [number, number, number];
}

/**
 * The surface on which the variable `of` equals `isovalue`, oriented towards lower values, each point once. It carries
 * the variables named in `carried`, linear along the edges of the grid.
 */
export function isosurface(volume: Volume, of: string, isovalue: number, carried: string[]): Mesh {
  const level = keepFromNodes(valuesOf(volume, of), volume.cells, isovalue);
  const { points, triangles } = marchingCubes(level, volume.cells, isovalue);
  const located = locate(points, level, volume.cells, isovalue);
  const position = new Float32Array(points.length);
  located.forEach(({ place }, i) => {
    position.set(
      place.map((along, axis) => volume.origin[axis] + volume.spacing * along),
      3 * i,
    );
  });
  const variables = carried.map((name) => {
    const source = name === of ? level : valuesOf(volume, name);
    const values = Float32Array.from(located, ({ low, high, t }) => (1 - t) * source[low] + t * source[high]);
    return { name, components: 1, values };
  });
  return { position, triangles, variables };
}

function valuesOf(volume: Volume, name: string): Float32Array {
  const variable = volume.variables.find((candidate) => candidate.name === name);
  if (!variable) {
    throw new Error(`The simulation “${volume.scene}” has no variable “${name}”.`);
  }
  return variable.values;
}

/** The values, with those moved that are so near to the isovalue that the surface would come too near their place. */
function keepFromNodes(values: Float32Array, cells: readonly number[], isovalue: number): Float32Array {
  const least = new Float32Array(values.length); // how far from the isovalue a value must be
  for (const [axis, stride] of [1, cells[0], cells[0] * cells[1]].entries()) {
    for (let low = 0; low + stride < values.length; ++low) {
      const high = low + stride;
      const isEdge = (Math.floor(low / stride) % cells[axis]) + 1 < cells[axis];
      if (isEdge && values[low] >= isovalue !== values[high] >= isovalue) {
        least[low] = Math.max(least[low], distanceFromEnds * Math.abs(values[high] - isovalue));
        least[high] = Math.max(least[high], distanceFromEnds * Math.abs(values[low] - isovalue));
      }
    }
  }
  return values.map((value, node) => {
    if (Math.abs(value - isovalue) >= least[node]) return value;
    return value >= isovalue ? isovalue + least[node] : isovalue - least[node];
  });
}

/** vtk.js's filter, with the grid's first value at the origin and its spacing 1. */
function marchingCubes(values: Float32Array, cells: readonly number[], isovalue: number) {
  const image = vtkImageData.newInstance();
  image.setDimensions(cells[0], cells[1], cells[2]);
  image.getPointData().setScalars(vtkDataArray.newInstance({ name: 'level', numberOfComponents: 1, values }));
  const filter = vtkImageMarchingCubes.newInstance({ contourValue: isovalue, mergePoints: true });
  filter.setInputData(image);
  const surface = quietly(() => filter.getOutputData());
  const faces = surface.getPolys().getData(); // 3, a, b, c, 3, a, b, c, ...
  return {
    points: surface.getPoints().getData() as Float32Array,
    triangles: Uint32Array.from(
      { length: (faces.length / 4) * 3 },
      (_, i) => faces[Math.floor(i / 3) * 4 + 1 + (i % 3)],
    ),
  };
}

/** Without the time that the filter prints. */
function quietly<Result>(work: () => Result): Result {
  const { time, timeEnd } = console;
  console.time = console.timeEnd = () => {};
  try {
    return work();
  } finally {
    Object.assign(console, { time, timeEnd });
  }
}

/** The edges of the grid that the points lie on, and where exactly: the filter has rounded to single precision. */
function locate(points: Float32Array, values: Float32Array, cells: readonly number[], isovalue: number): GridPoint[] {
  const strides = [1, cells[0], cells[0] * cells[1]];
  return Array.from({ length: points.length / 3 }, (_, i) => {
    const point = [...points.subarray(3 * i, 3 * i + 3)];
    const fromNode = point.map((along) => Math.abs(along - Math.round(along)));
    const axis = fromNode.indexOf(Math.max(...fromNode));
    const place = point.map((along, a) => (a === axis ? Math.floor(along) : Math.round(along)));
    const low = place.reduce((sum, along, a) => sum + along * strides[a], 0);
    const high = low + strides[axis];
    const t = (isovalue - values[low]) / (values[high] - values[low]);
    place[axis] += t;
    return { low, high, t, place: place as GridPoint['place'] };
  });
}
