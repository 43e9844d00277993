/**
 * Measures how fast Meshbound is beside meshoptimizer and VTK, on the same surfaces with the same variables, down to the same
 * number of triangles; --help says how.
 *
 * The contenders take turns, each in a process of its own. The table goes to standard output and, as it grows, to the file, in
 * place of what it has below the line that says so. What its columns mean stands in docs/speed.md.
 */
import { availableParallelism, cpus } from 'node:os';
import { writeBelow } from '../write-below.ts';
import type { Measurement, Size } from './cases.ts';
import { buildModule, buildNative, meshoptimizer, native, pythonWithVtk, vtk, wasm } from './contenders.ts';
import { makeMeshes } from './meshes.ts';
import { benchOptions, optionsOr } from './options.ts';
import { prepared } from './prerequisites.ts';
import { better, type Contender, type Row } from './row.ts';
import { table } from './table.ts';

const marker = '<!-- Below: tests/bench/bench.ts -->';

const usage = `npm run bench -- [--quick] [--sizes 7k,100k,1m,4m] [--variables 0,2,7] [--rounds NUMBER] [--out FILE]

  --quick      the two small surfaces with seven variables, once
  --sizes      of surfaces, by their triangles; all where it is not given
  --variables  how many the surfaces carry; all where it is not given
  --rounds     how often everything runs, the best counts
  --out        a file that gets the table, in place of the one it has`;

const { sizes, variables: variableSets, rounds, out } = optionsOr(usage, benchOptions);

/** All runs on one surface, in their order; those of the other tools leave as many triangles as the first. */
function runs({ path }: Size, variables: string[]): [Contender, (left: number) => Promise<Measurement>][] {
  return [
    ['native', () => native(path, variables, 'tracked', 1)],
    ['native, all threads', () => native(path, variables, 'tracked', availableParallelism())],
    ['module', () => wasm(path, variables, 'tracked')],
    ['native, propagated', () => native(path, variables, 'propagated', 1)],
    ['module, propagated', () => wasm(path, variables, 'propagated')],
    ['meshoptimizer', (left) => meshoptimizer(path, variables, left)],
    ['VTK', (left) => vtk(python, path, variables, left)],
  ];
}

async function measure(size: Size, variables: string[]): Promise<Row> {
  const row: Row = { size: size.name, variables: variables.length, results: {} };
  const failed = new Set<Contender>();
  for (let round = 0; round < (rounds ?? size.rounds); round++) {
    for (const [contender, run] of runs(size, variables)) {
      if (failed.has(contender)) continue;
      try {
        row.results[contender] = better(row.results[contender], await run(row.results.native?.left ?? 0));
      } catch (error) {
        failed.add(contender);
        console.error(`${size.name}, ${variables.length} variables, ${contender}: ${reason(error)}`);
      }
    }
  }
  return row;
}

/** What a program said last, where it is a program that failed. */
function reason(error: unknown): string {
  const said = error instanceof Error && 'stderr' in error ? String(error.stderr).trim().split('\n').at(-1) : '';
  return said || String(error);
}

function head(): string {
  const date = new Date().toISOString().slice(0, 10);
  const command = `npm run bench -- ${process.argv.slice(2).join(' ')}`.trim();
  return `Measured on ${date} on ${cpus().length} × ${cpus()[0]?.model}, Node ${process.versions.node}, by \`${command}\`.`;
}

const python = prepared(() => {
  const found = pythonWithVtk();
  buildModule();
  buildNative();
  makeMeshes(sizes, () => found);
  return found;
});

const rows: Row[] = [];
for (const size of sizes) {
  for (const variables of variableSets) {
    rows.push(await measure(size, variables));
    console.error(`${size.name} with ${variables.length} variables: done`);
    // As it grows: a long run can be looked at, or ended, on its way.
    if (out) writeBelow(out, marker, `${head()}\n\n${table(rows)}`);
  }
}
console.log(`${head()}\n\n${table(rows)}`);
