import { type ChildProcess, type SpawnOptions, spawn } from 'node:child_process';
import { existsSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { afterAll, vi } from 'vitest';
import type { Mesh } from '../../wasm/types.ts';
import { readSurface, type SurfaceFile } from '../../web/formats/read.ts';
import type { Format } from '../../web/formats/surface.ts';
import { writeSurface } from '../../web/formats/write.ts';

/** The program as it is shipped. */
export const program = resolve('build/cli/meshbound.mjs');

if (!existsSync(program)) throw new Error('These tests run the built command: npm run build first.');

// Some tests start several processes, and other tests run beside them.
vi.setConfig({ testTimeout: 120_000, hookTimeout: 120_000 });

export interface Outcome {
  status: number | null;
  signal: NodeJS.Signals | null;
  stdout: string;
  stderr: string;
}

/** Makes Node believe that standard error is a terminal. */
const terminal = ['--import', 'data:text/javascript,process.stderr.isTTY=true'];

/** A folder of its own for one file of tests, removed at the end. */
export class Folder {
  readonly path = mkdtempSync(join(tmpdir(), 'meshbound-cli-'));

  constructor() {
    afterAll(() => rmSync(this.path, { recursive: true, force: true }));
  }

  /** The names of all files in it, hidden ones too. */
  files(): string[] {
    return readdirSync(this.path).toSorted();
  }

  at(name: string): string {
    return join(this.path, name);
  }

  write(name: string, content: string | Uint8Array): void {
    writeFileSync(this.at(name), content);
  }

  text(name: string): string {
    return readFileSync(this.at(name), 'utf8');
  }

  async save(name: string, mesh: Mesh): Promise<void> {
    this.write(name, await writeSurface(name.split('.').at(-1) as Format, mesh));
  }

  read(name: string): Promise<SurfaceFile> {
    return readSurface(name, Uint8Array.from(readFileSync(this.at(name))));
  }

  /** Runs `meshbound` with these arguments in the folder. */
  run(...args: string[]): Promise<Outcome> {
    return this.outcome(spawn(process.execPath, [program, ...args], this.settings));
  }

  /** Runs it on what it takes for a terminal, and hands out the process while it runs. */
  runOnTerminal(...args: string[]): { child: ChildProcess; outcome: Promise<Outcome> } {
    const child = spawn(process.execPath, [...terminal, program, ...args], this.settings);
    return { child, outcome: this.outcome(child) };
  }

  /** Runs a line of shell in which `meshbound` is the command. */
  runShell(line: string): Promise<Outcome> {
    const script = `meshbound() { "${process.execPath}" "${program}" "$@"; }\n${line}`;
    return this.outcome(spawn('sh', ['-c', script], this.settings));
  }

  private get settings(): SpawnOptions {
    return { cwd: this.path, stdio: ['ignore', 'pipe', 'pipe'] };
  }

  private outcome(child: ChildProcess): Promise<Outcome> {
    const [stdout, stderr] = [child.stdout, child.stderr].map((stream) => {
      const chunks: Buffer[] = [];
      stream?.on('data', (chunk: Buffer) => chunks.push(chunk));
      return () => Buffer.concat(chunks).toString();
    });
    return new Promise((done, fail) => {
      child.on('error', fail);
      child.on('close', (status, signal) => done({ status, signal, stdout: stdout(), stderr: stderr() }));
    });
  }
}
