import { type Mesh, MeshboundError, type Reduction, reduce as reduceMesh } from '../../wasm/index.ts';
import { takenMapNames, triangleName, withMap } from '../formats/map-variables.ts';
import { listed } from '../formats/wording.ts';
import { oddityNotes } from '../session/oddity-notes.ts';
import { reportJson } from '../session/report-json.ts';
import { requireKnown, requireKnownBounds, unnamed } from './bound-arguments.ts';
import type { Command } from './command.ts';
import { exitStatus } from './exit-status.ts';
import { Fault, faultOf, UsageFault } from './fault.ts';
import { interruptible } from './interruption.ts';
import { sayNotes } from './notes.ts';
import { ProgressBar } from './progress-bar.ts';
import { help, parseRequest, type Request } from './reduce-arguments.ts';
import { freeNotes, reportText } from './report.ts';
import { requireWritable, StagedFiles } from './staged-files.ts';
import { encodeSurface, type OpenedSurface, openSurface, requirePlaceFor } from './surface-files.ts';

async function openInput({ input, variables: csv, exclude, options, map }: Request): Promise<OpenedSurface> {
  const whole = await openSurface(input, csv);
  requireKnown(exclude, whole);
  if (exclude.includes('position')) throw new UsageFault('--exclude: the position cannot be left out.');
  const variables = whole.mesh.variables.filter(({ name }) => !exclude.includes(name));
  const surface = { ...whole, mesh: { ...whole.mesh, variables } };
  requireKnownBounds(options.bounds, surface);
  if (map) {
    requireMapNames(surface);
    await requirePlaceFor(triangleName, map);
  }
  return surface;
}

/** Throws a Fault where the names that the map needs are taken by variables of the surface. */
function requireMapNames({ path, mesh }: OpenedSurface): void {
  const taken = takenMapNames(mesh);
  if (taken.length > 0) throw new Fault(`${path}: --map needs the names of the variables ${listed(taken)} for itself.`);
}

async function reduceSurface({ path, mesh, locked }: OpenedSurface, request: Request, signal: AbortSignal) {
  const { bounds, errors, cost } = request.options;
  const bar = process.stderr.isTTY && !request.quiet ? new ProgressBar(process.stderr) : undefined;
  try {
    return await reduceMesh(mesh, {
      bounds,
      errors,
      cost: cost === 'max' ? 'maximum' : 'introduced',
      locked,
      signal,
      onProgress: (progress) => bar?.show(progress),
    });
  } catch (error) {
    throw withAdvice(path, error);
  } finally {
    bar?.clear();
  }
}

function withAdvice(path: string, error: unknown): unknown {
  const fault = faultOf(path, error);
  const excludable = error instanceof MeshboundError && error.code === 'non_finite_value' && fault instanceof Fault;
  return excludable ? new Fault(`${fault.message} To leave the variable out: --exclude "${error.variable}".`) : fault;
}

/** Writes what was asked for, and gives the notes on each file of what it does not hold. */
async function writeResults(files: StagedFiles, request: Request, surface: OpenedSurface, reduction: Reduction) {
  const { output, map, report, options } = request;
  const surfaces: [string, Mesh][] = [[output, reduction.mesh]];
  if (map) surfaces.push([map, withMap(surface.mesh, reduction)]);
  const notes: [string, string[]][] = [];
  for (const [path, mesh] of surfaces) {
    const { bytes, losses } = await encodeSurface(path, mesh, surface);
    await files.write(path, bytes);
    notes.push([path, losses]);
  }
  if (report) await files.write(report, reportJson(reduction.report, options));
  return notes;
}

async function run(args: string[]): Promise<number> {
  const request = parseRequest(args);
  const { output, map, report, options, quiet } = request;
  await requireWritable([output, map, report].filter((path) => path !== undefined));
  const surface = await openInput(request);
  const { result, notes } = await interruptible((signal) =>
    StagedFiles.complete(signal, async (files) => {
      const result = await reduceSurface(surface, request, signal);
      return { result, notes: await writeResults(files, request, surface, result) };
    }),
  );
  if (!quiet) {
    if (options.cost === 'max' && options.errors === 'tracked') {
      console.error('--cost has an effect with --errors propagated only.');
    }
    const free = freeNotes(unnamed(options.bounds, surface.mesh));
    sayNotes(surface.path, [...surface.notes, ...oddityNotes(result.report.oddities), ...free]);
    for (const [path, losses] of notes) sayNotes(path, losses);
    console.log(reportText(result.report, options));
  }
  return exitStatus.done;
}

export const reduce: Command = { help, run };
