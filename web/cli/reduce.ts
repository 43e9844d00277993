import { type Mesh, MeshboundError, type Reduction, reduce as reduceMesh } from '../../wasm/index.ts';
import { oddityNotes } from '../session/oddity-notes.ts';
import { oneOf, parseArguments } from './arguments.ts';
import { parseBounds, requireKnown, requireKnownBounds, unnamed } from './bound-arguments.ts';
import type { Command } from './command.ts';
import { exitStatus } from './exit-status.ts';
import { Fault, faultOf, UsageFault } from './fault.ts';
import { interruptible } from './interruption.ts';
import { requireMapNames, triangleName, withMap } from './map-variables.ts';
import { sayNotes } from './notes.ts';
import { ProgressBar } from './progress-bar.ts';
import { freeNotes, type ReportOptions, reportJson, reportText } from './report.ts';
import { requireWritable, StagedFiles } from './staged-files.ts';
import { encodeSurface, type OpenedSurface, openSurface, outputFormat, requirePlaceFor } from './surface-files.ts';

const help = `Reduces a surface so that every bound holds at every point of it.

Usage: meshbound reduce IN -o OUT --bound NAME=BOUND …

A bound is the largest allowed error of a variable: 1% of its extent (the length of the diagonal of the box of its
values), 0.2 in its unit, or free. "position" is the geometry, "*" every variable not named; of two bounds with one name
the later one holds. A variable without bound is free: it is carried along, and nothing is promised of it.

Options:
  -o, --output OUT        the file to write: .vtp, .vtk, .ply, .glb, .obj or .stl, and .gz behind any of them
  -b, --bound NAME=BOUND  as often as needed
  --variables FILE.csv    more variables of IN: names in the first line, then a line for each point
  --exclude NAME          leave a variable out, as often as needed
  --errors HOW            tracked (default): measured against the original at every step;
                          propagated: added up from removal to removal, as in the paper; more triangles stay
  --cost WHAT             with propagated errors, what the choice among retriangulations makes small:
                          introduced (default): the error of this removal; max: the error so far
  --map FILE              also write the original with where each vertex went, and what error it has there
  --report FILE.json      also write counts, bounds and errors for programs
  --quiet                 say nothing but errors

On a terminal a bar shows the progress. Ctrl-C ends the reduction and leaves all files as they were.

Examples:
  meshbound reduce engine.vtp -o small.vtp --bound position=1% --bound "*=3%"
  meshbound reduce engine.vtp -o small.ply -b position=0.5 -b pressure=2% -b velocity=0.2 -b temperature=free
  meshbound reduce engine.vtp -o small.vtp -b "*=1%" --map where.vtp --report report.json`;

const signature = {
  options: {
    output: { type: 'string', short: 'o' },
    bound: { type: 'string', short: 'b', multiple: true, default: [] as string[] },
    variables: { type: 'string' },
    exclude: { type: 'string', multiple: true, default: [] as string[] },
    errors: { type: 'string', default: 'tracked' },
    cost: { type: 'string', default: 'introduced' },
    map: { type: 'string' },
    report: { type: 'string' },
    levels: { type: 'string' },
    quiet: { type: 'boolean', default: false },
  },
  positionals: ['IN'],
} as const;

interface Request {
  input: string;
  output: string;
  variables: string | undefined;
  exclude: string[];
  options: ReportOptions;
  map: string | undefined;
  report: string | undefined;
  quiet: boolean;
}

function parseRequest(args: string[]): Request {
  const { values, positionals } = parseArguments(args, signature);
  if (values.levels !== undefined) throw new UsageFault('--levels: several levels of detail cannot be made yet.');
  if (!values.output) throw new UsageFault('-o OUT is missing.');
  const errors = oneOf('--errors', values.errors, ['tracked', 'propagated']);
  if (values.map && errors === 'propagated') throw new UsageFault('--map goes with --errors tracked.');
  const cost = oneOf('--cost', values.cost, ['max', 'introduced']);
  for (const path of [values.output, values.map]) if (path) outputFormat(path);
  return {
    input: positionals[0],
    output: values.output,
    variables: values.variables,
    exclude: values.exclude,
    options: { bounds: parseBounds(values.bound), errors, cost },
    map: values.map,
    report: values.report,
    quiet: values.quiet,
  };
}

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
