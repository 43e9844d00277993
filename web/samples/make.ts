import { extent } from 'd3-array';

import type { Mesh } from '../../wasm/types.ts';
import type { ListedSample, Sample } from './catalogue.ts';
import { isosurface } from './isosurface.ts';
import { plyOf } from './ply.ts';
import { simulate, type Volume } from './simulate.ts';
import { type Topology, topology } from './topology.ts';

/** The variable whose isosurfaces the samples are. */
const followed = 'density';

/**
 * Simulates a sample's flow and takes its surface. The simulator must have been built.
 * Throws where the surface is not an oriented manifold.
 */
export function makeSample(sample: Sample): { entry: ListedSample; ply: Buffer; summary: string } {
  const volume = simulate(sample.scene, sample.cells);
  const mesh = isosurface(volume, followed, sample.isovalue, sample.variables);
  const vertices = mesh.position.length / 3;
  const shape = topology(mesh.triangles, vertices);
  if (shape.badEdges > 0 || shape.badVertices > 0) {
    throw new Error(
      `${sample.name} is no oriented manifold: ${shape.badEdges} edges, ${shape.badVertices} vertices are at fault.`,
    );
  }
  const units = unitsOf(volume, sample);
  const entry: ListedSample = {
    name: sample.name,
    title: sample.title,
    description: sample.description,
    file: `${sample.name}.ply`,
    triangles: mesh.triangles.length / 3,
    vertices,
    boundaryLoops: shape.boundaryLoops,
    components: shape.components,
    units,
  };
  return { entry, ply: plyOf(mesh, commentsOf(sample, volume, units)), summary: summaryOf(mesh, shape, volume) };
}

function unitsOf(volume: Volume, sample: Sample): Record<string, string> {
  const unit = (name: string) => volume.variables.find((variable) => variable.name === name)?.unit ?? '1';
  return { position: volume.lengthUnit, ...Object.fromEntries(sample.variables.map((name) => [name, unit(name)])) };
}

function commentsOf(sample: Sample, volume: Volume, units: Record<string, string>): string[] {
  const density = volume.variables.find(({ name }) => name === followed);
  return [
    `${sample.title}: ${sample.description}`,
    `Made by Meshbound: compressible Euler equations, MUSCL-Hancock with HLLC, ${sample.cells.join(' x ')} cells, ` +
      `${volume.steps} steps to time ${volume.end}`,
    `isosurface of ${followed} at ${sample.isovalue} ${density?.unit}, oriented towards lower ${followed}`,
    ...Object.entries(units).map(([name, unit]) => `unit ${name} ${unit}`),
  ];
}

function summaryOf(mesh: Mesh, shape: Topology, volume: Volume): string {
  const ranges = mesh.variables.map(({ name, values }) => {
    const [lowest = Number.NaN, highest = Number.NaN] = extent(values);
    return `${name} ${lowest.toPrecision(3)}...${highest.toPrecision(3)}`;
  });
  return (
    `${volume.steps} steps, ${mesh.triangles.length / 3} triangles, ${shape.components} components, ` +
    `${shape.boundaryLoops} boundary loops, ${ranges.join(', ')}`
  );
}
