import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { samples } from '../../web/samples/catalogue.ts';
import { folder, fromRoot, type Size } from './cases.ts';

/** How many times finer a grid than that of the finest sample gives so many triangles. */
const refinements: Record<string, number> = { '1m': 2.81, '4m': 5.63 };

const simulator = fromRoot('build/samples-simulator/samples-simulator');
const finest = samples.find(({ name }) => name === 'fireballs-fine');

/** Makes the surfaces that are missing; the samples among them are the build's to make. */
export function makeMeshes(sizes: Size[], python: string): void {
  const missing = sizes.filter(({ path }) => !existsSync(path));
  if (missing.length === 0) return;
  const foreign = missing.find(({ name }) => !(name in refinements));
  if (foreign) throw new Error(`${foreign.path} is missing: run npm run build.`);

  mkdirSync(folder, { recursive: true });
  const volume = { description: join(folder, 'volume.json'), numbers: join(folder, 'volume.raw') };
  if (!existsSync(volume.description)) simulate(volume.description, volume.numbers);
  const wanted = missing.map(({ name }) => `fireballs-${name}=${refinements[name]}`);
  const script = fromRoot('tests/bench/make_meshes.py');
  execFileSync(python, [script, volume.description, volume.numbers, folder, ...wanted], {
    stdio: ['ignore', process.stderr, 'inherit'],
  });
}

function simulate(description: string, numbers: string): void {
  if (!finest) throw new Error('The finest sample is not in the catalogue.');
  const output = execFileSync(simulator, [finest.scene, ...finest.cells.map(String), numbers], { encoding: 'utf8' });
  writeFileSync(description, output);
}
