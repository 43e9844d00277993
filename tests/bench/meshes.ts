import { execFileSync } from 'node:child_process';
import { closeSync, existsSync, mkdirSync, openSync, writeFileSync, writeSync } from 'node:fs';
import { join } from 'node:path';
import { samples } from '../../web/samples/catalogue.ts';
import { buildSimulator, simulate } from '../../web/samples/simulate.ts';
import { folder, fromRoot, type Size } from './cases.ts';

/** How many times finer a grid than that of the finest sample gives so many triangles. */
const refinements: Record<string, number> = { '1m': 2.81, '4m': 5.63 };

const finest = samples.find(({ name }) => name === 'fireballs-fine');

/** The files of a volume: what it is, as JSON, and its numbers, one variable after the other. */
export interface VolumeFiles {
  description: string;
  numbers: string;
}

/** Makes the surfaces that are missing, by a Python with VTK; the samples among them are the build's to make. */
export function makeMeshes(sizes: Size[], python: () => string): void {
  const missing = sizes.filter(({ path }) => !existsSync(path));
  if (missing.length === 0) return;
  const foreign = missing.find(({ name }) => !(name in refinements));
  if (foreign) throw new Error(`${foreign.path} is missing: run npm run build.`);
  if (!finest) throw new Error('The finest sample is not in the catalogue.');

  mkdirSync(folder, { recursive: true });
  const volume = { description: join(folder, 'volume.json'), numbers: join(folder, 'volume.raw') };
  if (!existsSync(volume.description)) makeVolume(finest.scene, finest.cells, volume);
  const wanted = missing.map(({ name }) => `fireballs-${name}=${refinements[name]}`);
  const script = fromRoot('tests/bench/make_meshes.py');
  execFileSync(python(), [script, volume.description, volume.numbers, folder, ...wanted], {
    stdio: ['ignore', process.stderr, 'inherit'],
  });
}

/** Simulates a scene. The build compiles the simulator only where it has samples to make, so that it may be missing. */
export function makeVolume(scene: string, cells: readonly number[], { description, numbers }: VolumeFiles): void {
  buildSimulator();
  const volume = simulate(scene, cells);
  const file = openSync(numbers, 'w');
  for (const { values } of volume.variables) writeSync(file, values);
  closeSync(file);
  const variables = volume.variables.map(({ name, unit }) => ({ name, unit }));
  // Last: a description stands for a volume that is complete.
  writeFileSync(description, JSON.stringify({ ...volume, variables }));
}
