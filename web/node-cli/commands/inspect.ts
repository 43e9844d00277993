import type { Variable } from '../../../wasm/index.ts';
import { withoutRegionNotes } from '../../formats/regions/region-notes.ts';
import { counted, grouped, listed, printable, quoted } from '../../formats/text/wording.ts';
import { nonFiniteWords } from '../../session/report/defect-notes.ts';
import { coincidentIn } from '../../surface/coincident.ts';
import { topologyOf } from '../../surface/topology.ts';
import { usedPoints } from '../../surface/used-points.ts';
import { spanOf } from '../../surface/value-span.ts';
import type { Command } from '../command.ts';
import { exitStatus } from '../exit-status.ts';
import { type OpenedSurface, openSurface } from '../files/surface-files.ts';
import { parseArguments } from '../options/arguments.ts';
import { parseWeld, weldHelp } from '../options/weld-argument.ts';
import { sayNotes } from '../output/notes.ts';
import { numberText, rangeTexts, textTable } from '../output/text-table.ts';

const help = `Shows what a surface is like, and what its variables span.

Usage: meshbound inspect FILE

Shows the numbers of triangles, vertices, components (parts that share no vertex) and boundary loops; edges of three or
more triangles or of two that disagree about the orientation, and vertices whose triangles do not form one fan; and of
each variable its components, range, extent (the length of the diagonal of the box of its values, of which a relative
bound is a fraction) and how many values are NaN or infinite.

Options:
  --variables FILE.csv    more variables of FILE: names in the first line, then a line for each point
  ${weldHelp}
  --json                  the same for programs
  --quiet                 say nothing of how the file was read

Examples:
  meshbound inspect engine.vtp
  meshbound inspect --json engine.vtp | jq '.variables[].name'`;

/** What `--json` prints; documented in docs/command-line.md. */
function inspection({ path, format, mesh, units, componentNames, notes, regions, unfitRegions }: OpenedSurface) {
  const vertices = mesh.position.length / 3;
  const describe = (variable: Variable) => {
    const {
      components,
      extent,
      magnitude,
      constant,
      nan,
      infinite,
      nonFinite = null,
    } = spanOf(variable, mesh.triangles);
    return {
      name: variable.name,
      components: variable.components,
      kind: variable.kind ?? 'quantity',
      componentNames: componentNames[variable.name] ?? null,
      unit: units[variable.name] ?? null,
      precision: variable.values instanceof Float64Array ? 'double' : 'single',
      range: components.map(({ lowest, highest }) => (lowest <= highest ? [lowest, highest] : null)),
      extent,
      magnitude,
      constant,
      nan,
      infinite,
      nonFinite,
    };
  };
  const position = { name: 'position', components: 3, values: mesh.position };
  return {
    file: path,
    format,
    triangles: mesh.triangles.length / 3,
    vertices,
    unusedVertices: usedPoints(mesh.triangles, vertices).filter((used) => used === 0).length,
    ...topologyOf(mesh.triangles, vertices),
    defects: coincidentIn(mesh.triangles, vertices),
    variables: [position, ...mesh.variables].map(describe),
    cellData: [
      ...[...(regions ?? [])].map(([name, labels]) => ({ name, labels: new Set(labels).size, unfit: null })),
      ...[...(unfitRegions ?? [])].map(([name, unfit]) => ({ name, labels: null, unfit })),
    ],
    notes: withoutRegionNotes(notes, regions),
  };
}

type Inspection = ReturnType<typeof inspection>;

/** Which cell data `reduce --region` takes, and why it does not take others. */
function cellDataLines({ cellData }: Inspection): string[] {
  return cellData.map(({ name, labels, unfit }) =>
    labels === null
      ? `  Cell data ${quoted(name)} cannot part the surface into regions: ${printable(unfit ?? '')}.`
      : `  Cell data ${quoted(name)}, ${counted(labels, 'label')}: --region takes it, and parts the surface by it.`,
  );
}

function countsText(found: Inspection): string {
  const counts: [string, number][] = [
    ['triangles', found.triangles],
    ['vertices', found.vertices],
    ...unusedRow(found),
    ['components', found.components],
    ...coincidentRows(found),
    ['boundary loops', found.boundaryLoops],
    ['non-manifold edges', found.nonManifoldEdges],
    ...discordantRow(found),
    ['non-manifold vertices', found.nonManifoldVertices],
  ];
  return textTable(counts.map(([name, count]) => [name, grouped(count)]));
}

/** Where triangles face different ways `reduce` turns them, so that such edges are no trouble. */
function discordantRow({ discordantEdges }: Inspection): [string, number][] {
  return discordantEdges > 0 ? [['  between triangles facing different ways', discordantEdges]] : [];
}

/** Triangles on the same three points: `reduce` takes both sides of a sheet together, and leaves copies out. */
function coincidentRows({ defects: { copiedTriangles, twoSidedTriangles } }: Inspection): [string, number][] {
  const rows: [string, number][] = [
    ['pairs of triangles that are two sides', twoSidedTriangles],
    ['copies of other triangles', copiedTriangles],
  ];
  return rows.filter(([, count]) => count > 0);
}

/** What stands at such vertices counts for nothing, in the table below either. */
function unusedRow({ unusedVertices }: Inspection): [string, number][] {
  return unusedVertices > 0 ? [['  that no triangle uses', unusedVertices]] : [];
}

const heading = ['variable', 'components', 'lowest', 'highest', 'extent', 'NaN', 'infinite'];

/** A row for the variable, and one for each component where there are several. */
function variableRows({
  name,
  unit,
  components,
  componentNames,
  range,
  extent,
  nan,
  infinite,
}: Inspection['variables'][0]) {
  const ends = range.map((each) => (each ? rangeTexts(each) : ['', '']));
  const title = unit ? `${name} (${unit})` : name;
  const single = components === 1;
  const row = [
    title,
    String(components),
    ...(single ? ends[0] : ['', '']),
    numberText(extent),
    String(nan),
    String(infinite),
  ];
  const names = componentNames ?? (name === 'position' ? ['x', 'y', 'z'] : []);
  const parts = ends.map(([lowest, highest], i) => [`  ${names[i] ?? i}`, '', lowest, highest, '', '', '']);
  return single ? [row] : [row, ...parts];
}

function unboundedText(name: string): string {
  if (name === 'position') return 'so the surface cannot be reduced';
  return 'it can have no bound; free, it is carried along as it is';
}

function print(found: Inspection): void {
  console.log(`${found.file} (${found.format.toUpperCase()})`);
  console.log(countsText(found));
  console.log();
  console.log(textTable([heading, ...found.variables.flatMap(variableRows)]));
  const identifiers = found.variables.filter(({ kind }) => kind === 'identifier').map(({ name }) => name);
  if (identifiers.length > 0) {
    console.log(
      `\n  Identifiers: ${listed(identifiers)}. Only a bound of that name is about them; “*” leaves them free.`,
    );
  }
  for (const { name, nonFinite } of found.variables) {
    if (nonFinite) console.log(`\n  ${nonFiniteWords(name, nonFinite)}: ${unboundedText(name)}.`);
  }
  const constant = found.variables.filter((each) => each.constant).map(({ name }) => name);
  if (constant.length > 0) {
    console.log(
      `\n  Constant up to rounding: ${listed(constant)}. Relative bounds are fractions of the magnitude there.`,
    );
  }
}

function printCellData(found: Inspection): void {
  const lines = cellDataLines(found);
  if (lines.length > 0) console.log(`\n${lines.join('\n')}`);
}

async function run(args: string[]): Promise<number> {
  const { values, positionals } = parseArguments(args, {
    options: {
      variables: { type: 'string' },
      weld: { type: 'string' },
      json: { type: 'boolean' },
      quiet: { type: 'boolean' },
    },
    positionals: ['FILE'],
  });
  const surface = await openSurface(positionals[0], values.variables, { weld: parseWeld(values.weld) });
  const found = inspection(surface);
  if (values.json) console.log(JSON.stringify(found, undefined, 2));
  else {
    print(found);
    printCellData(found);
  }
  if (!values.quiet && !values.json) sayNotes(surface.path, found.notes);
  return exitStatus.done;
}

export const inspect: Command = { help, run };
