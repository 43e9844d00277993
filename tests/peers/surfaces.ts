import { existsSync, mkdirSync, readdirSync, readFileSync, statSync, writeFileSync } from 'node:fs';
import { basename, join } from 'node:path';

import type { Mesh } from '../../wasm/types.ts';
import { readPly } from '../../web/formats/ply/read-ply.ts';
import { writePly } from '../../web/formats/ply/write-ply.ts';
import { bunnyMesh } from './bunny.ts';
import { makeSurfaces } from './native.ts';
import { places } from './places.ts';

export interface SurfaceFile {
  name: string;
  path: string;
}

/** The surfaces that a short comparison runs over, where they are there; and those that always are. */
export const quickSurfaces = ['post_speed', 'notch_stress', 'rectgrid2'];
export const quickSurfacesWithoutData = ['noisy-sphere', 'twisted-band', 'plate'];

/**
 * All surfaces that there are, small files first: those of the environment variable MESHBOUND_DATA (a folder of PLY files),
 * the samples that the build makes, the bunny, and the generated ones.
 */
export function findSurfaces(): SurfaceFile[] {
  mkdirSync(places.surfaces, { recursive: true });
  makeSurfaces();
  writeFileSync(join(places.surfaces, 'bunny.ply'), writePly(bunnyMesh()));
  const folders = [process.env.MESHBOUND_DATA, places.samples, places.surfaces];
  return folders.flatMap((folder) => plyFiles(folder)).sort((a, b) => statSync(a.path).size - statSync(b.path).size);
}

function plyFiles(folder: string | undefined): SurfaceFile[] {
  if (!folder || !existsSync(folder)) return [];
  const files = readdirSync(folder).filter((file) => file.endsWith('.ply'));
  return files.map((file) => ({ name: basename(file, '.ply'), path: join(folder, file) }));
}

/** The mesh with every component as a variable of its own, which is how the native side reads the file. */
export function readScalars(path: string): Mesh {
  const { mesh } = readPly(readFileSync(path));
  const variables = mesh.variables.flatMap(({ name, components, values }) =>
    Array.from({ length: components }, (_, component) => ({
      name: components === 1 ? name : `${name}, component ${component}`,
      components: 1,
      values: values.filter((_value, index) => index % components === component),
    })),
  );
  return { ...mesh, variables };
}
