import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

const sources = fileURLToPath(new URL('.', import.meta.url));
const binaries = fileURLToPath(new URL('../../build/samples-simulator/', import.meta.url));
const simulator = join(binaries, 'samples-simulator');

/** Sums over the whole box. */
export interface Totals {
  mass: number;
  energy: number;
  /** Of each traced material. */
  partialMass: number[];
}

/** Values on a regular grid, x fastest. */
export interface Volume {
  scene: string;
  lengthUnit: string;
  /** Numbers of values along x, y, z. */
  cells: [number, number, number];
  /** Where the first value stands, in `lengthUnit`. */
  origin: [number, number, number];
  /** Distance of neighbouring values, in `lengthUnit`. */
  spacing: number;
  /** The time simulated, in the scene's unit, and the number of steps that it took. */
  end: number;
  steps: number;
  before: Totals;
  after: Totals;
  variables: { name: string; unit: string; values: Float32Array }[];
}

/** Compiles the simulator where it is missing or older than its sources. */
export function buildSimulator(): void {
  execFileSync('cmake', ['-S', sources, '-B', binaries], { stdio: ['ignore', 'ignore', 'inherit'] });
  execFileSync('cmake', ['--build', binaries, '--parallel', '2'], { stdio: ['ignore', 'ignore', 'inherit'] });
}

/** Runs a scene (see main.cpp for the options) and returns its last state. Throws where the simulator fails. */
export function simulate(scene: string, cells: readonly number[], options: string[] = []): Volume {
  mkdirSync(binaries, { recursive: true });
  const file = join(binaries, `${scene}-${cells.join('x')}-${process.pid}.raw`);
  try {
    const output = execFileSync(simulator, [scene, ...cells.map(String), file, ...options], {
      encoding: 'utf8',
      stdio: ['ignore', 'pipe', 'pipe'],
    });
    const volume = JSON.parse(output) as Volume;
    const bytes = readFileSync(file);
    const numbers = new Float32Array(bytes.buffer, bytes.byteOffset, bytes.byteLength / Float32Array.BYTES_PER_ELEMENT);
    const size = volume.cells[0] * volume.cells[1] * volume.cells[2];
    volume.variables.forEach((variable, index) => {
      variable.values = numbers.subarray(index * size, (index + 1) * size);
    });
    return volume;
  } finally {
    rmSync(file, { force: true });
  }
}
