import { execFile, execFileSync, spawnSync } from 'node:child_process';
import { existsSync } from 'node:fs';
import { promisify } from 'node:util';
import { type Errors, folder, fromRoot, type Measurement } from './cases.ts';

const run = promisify(execFile);
const tsx = fromRoot('node_modules/.bin/tsx');
const nativeSources = fromRoot('tests/bench');
const nativeBuild = `${folder}/native`;
/** Debian's packages serve its own Python; another one may come first on the path. */
const interpreters = ['/usr/bin/python3', 'python3'];

/** Builds the module and the samples, where something changed. */
export function buildModule(): void {
  execFileSync(fromRoot('scripts/build.sh'), { stdio: ['ignore', process.stderr, 'inherit'] });
}

/** Compiles the native side with the core as it is now; quick where nothing changed. */
export function buildNative(): void {
  const cmake = (...given: string[]) => execFileSync('cmake', given, { stdio: ['ignore', process.stderr, 'inherit'] });
  if (!existsSync(`${nativeBuild}/build.ninja`)) {
    cmake('-S', nativeSources, '-B', nativeBuild, '-G', 'Ninja', '-DCMAKE_BUILD_TYPE=Release');
  }
  cmake('--build', nativeBuild);
}

/** The first Python that has VTK, if any. */
export function findPythonWithVtk(): string | undefined {
  const has = (python: string) => spawnSync(python, ['-c', 'import vtkmodules.vtkCommonCore, numpy']).status === 0;
  return interpreters.find(has);
}

export function pythonWithVtk(): string {
  const python = findPythonWithVtk();
  if (!python)
    throw new Error('No Python with VTK: apt-get install --no-install-recommends python3-vtk9 python3-numpy.');
  return python;
}

/** Each runs in a process of its own, so that no one's memory or compiled code is another's. */
export async function native(path: string, variables: string[], errors: Errors, threads: number): Promise<Measurement> {
  const { stdout } = await run(`${nativeBuild}/bench_reduce`, [
    ...[path, variables.join(','), errors, String(threads)],
    '--benchmark_format=json',
  ]);
  const [result] = JSON.parse(stdout).benchmarks;
  return {
    wall: result.real_time / 1000,
    cpu: result.cpu_time / 1000,
    triangles: result.triangles,
    left: result.left,
    peakBytes: result.peak_bytes,
  };
}

export function wasm(path: string, variables: string[], errors: Errors): Promise<Measurement> {
  return measurement(tsx, [fromRoot('tests/bench/module-run.ts'), path, variables.join(','), errors]);
}

export function meshoptimizer(path: string, variables: string[], left: number): Promise<Measurement> {
  return measurement(tsx, [fromRoot('tests/bench/meshoptimizer-run.ts'), path, variables.join(','), String(left)]);
}

export function vtk(python: string, path: string, variables: string[], left: number): Promise<Measurement> {
  return measurement(python, [fromRoot('tests/bench/vtk_run.py'), path, variables.join(','), String(left)]);
}

async function measurement(program: string, programArguments: string[]): Promise<Measurement> {
  const { stdout } = await run(program, programArguments);
  return JSON.parse(stdout) as Measurement;
}
