import { execFileSync, spawnSync } from 'node:child_process';
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

const fromRoot = (path: string) => fileURLToPath(new URL(`../../${path}`, import.meta.url));
const program = fromRoot('build/native/tests/instructions_run');
const storedFile = fromRoot('tests/bench/instructions.json');

/** The ways of accounting for errors that are counted. */
export const modes = ['tracked', 'propagated'] as const;
export type Mode = (typeof modes)[number];

/** What the fixed small run (instructions_main.cpp) takes. */
export interface Count {
  instructions: number;
  /** Triangles left: where they differ, the run does other work, not the same work in another time. */
  triangles: number;
}

/** The counts to compare with. They hold for one compiler: another one makes other instructions of the same sources. */
export interface Stored {
  compiler: string;
  counts: Record<Mode, Count>;
}

/** Why nothing can be counted here; nothing where it can. */
export function obstacle(): string | undefined {
  if (!existsSync(program))
    return 'the native build is missing (cmake --preset native && cmake --build --preset native)';
  if (spawnSync('valgrind', ['--version']).status !== 0) return 'valgrind is missing';
  return undefined;
}

/** The compiler, processor and kind of the native build. */
export function compiler(): string {
  return execFileSync(program, ['compiler'], { encoding: 'utf8' }).trim();
}

/** Runs under Callgrind, which counts the same whatever else the machine does. */
export function count(mode: Mode): Count {
  const { status, stdout, stderr } = spawnSync(
    'valgrind',
    ['--tool=callgrind', '--callgrind-out-file=/dev/null', program, mode],
    { encoding: 'utf8' },
  );
  const collected = stderr.match(/Collected : (\d+)/);
  if (status !== 0 || !collected) throw new Error(`valgrind failed: ${stderr}`);
  return { instructions: Number(collected[1]), triangles: Number(stdout) };
}

export function readStored(): Stored {
  return JSON.parse(readFileSync(storedFile, 'utf8')) as Stored;
}

export function store(counts: Stored): void {
  writeFileSync(storedFile, `${JSON.stringify(counts, null, 2)}\n`);
}
