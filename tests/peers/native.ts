import { execFileSync } from 'node:child_process';
import { existsSync } from 'node:fs';
import { join } from 'node:path';

import { LineServer } from './line-server.ts';
import { places } from './places.ts';

/** Compiles the judge with the core as it is now; quick where nothing changed. */
export function buildNative(): void {
  const run = (...programArguments: string[]) =>
    execFileSync('cmake', programArguments, { stdio: ['ignore', process.stderr, process.stderr] });
  if (!existsSync(join(places.nativeBuild, 'build.ninja'))) {
    run('-S', places.nativeSources, '-B', places.nativeBuild, '-G', 'Ninja', '-DCMAKE_BUILD_TYPE=Release');
  }
  run('--build', places.nativeBuild);
}

/** Writes the generated surfaces into the folder of the surfaces. */
export function makeSurfaces(): void {
  execFileSync(join(places.nativeBuild, 'peers_surfaces'), [places.surfaces], { stdio: 'inherit' });
}

/** What Meshbound leaves, and what the judge says of it. */
export interface Reduced {
  triangles: number;
  seconds: number;
  ratio: number;
  boundaryRatio: number;
}

/** The judge is exact to this fraction of a bound. */
export const hair = 1e-6;

/** The judge's, of surface and boundary; at most 1 + hair where the bounds are kept. */
export function ratio(reduced: Reduced): number {
  return Math.max(reduced.ratio, reduced.boundaryRatio);
}

/** The judge of one surface at one pair of bounds at a time, and Meshbound beside it (judge_main.cpp). */
export class Judge {
  private readonly server = new LineServer(join(places.nativeBuild, 'peers_judge'));

  /** Returns the number of triangles. */
  async open(surface: string): Promise<number> {
    return (await this.numbers(`surface ${surface}`))[0];
  }

  /** In percent; returns the absolute bounds, position first. */
  bound(geometry: number, variables: number): Promise<number[]> {
    return this.numbers(`bounds ${geometry} ${variables}`);
  }

  /** Nothing where the mesh in a PLY file lies within the bounds; else the variable at fault, 0 for position. */
  async beyond(path: string): Promise<number | undefined> {
    const [variable] = await this.numbers(`beyond ${path}`);
    return variable < 0 ? undefined : variable;
  }

  async reduce(errors: 'tracked' | 'propagated'): Promise<Reduced> {
    const [triangles, seconds, ratio, boundaryRatio] = await this.numbers(`reduce ${errors}`);
    return { triangles, seconds, ratio, boundaryRatio };
  }

  /** Of surface and boundary, for the mesh in a PLY file. */
  async ratios(path: string): Promise<[number, number]> {
    const [surface, boundary] = await this.numbers(`ratio ${path}`);
    return [surface, boundary];
  }

  close(): void {
    this.server.close();
  }

  private async numbers(request: string): Promise<number[]> {
    const [, ...words] = (await this.server.ask(request)).split(' ');
    return words.map((word) => (word === 'inf' ? Number.POSITIVE_INFINITY : Number(word)));
  }
}
