import { readFileSync } from 'node:fs';

import type { Surface } from '../../web/formats/surface.ts';
import { spanOf } from '../../web/surface/value-span.ts';
import { shortNumber, unitText } from './markdown.ts';
import { type PaperCase, paperCases } from './paper.ts';
import { pictureFile } from './pictures.ts';

/** The tables, in Markdown, and the samples that they are about. */
export interface Parts {
  paper: { counts: string; errors: string };
  reference: string;
  other: string;
  samples: Map<string, Surface>;
}

export function evaluationDocument({ paper, reference, other, samples }: Parts): string {
  return `# The paper's evaluation, repeated

This page, with all its numbers and pictures, is written by \`npm run evaluate\`. Sections (§) are those of
C. Bajaj and D. Schikore, *Error-bounded Reduction of Triangle Meshes with Multivariate Data* (1996); the method is described
in [algorithm.md](algorithm.md).

*Propagated* is the paper's accounting of errors, *tracked* is ours and the default. Both guarantee that there is a continuous
map from the original surface onto the reduced one which keeps every bound at every point. The judge (\`meshbound/verify.hpp\`) knows
nothing of either: it looks at the two surfaces in the joint space of position and variables, at some 50 000 points of each.
Where it finds a bound broken, the evaluation fails and writes nothing.

## The surfaces of §5

The paper's data cannot be had. In its place stand two simulations of the project's own, on grids of the same size and
with as many variables: an isosurface of density in a collision of two balls of gas (\`fireballs\`, 70×40×25, seven
variables), and one in an impact on a plate (\`impact\`, 54×24×24, six variables). The bounds are the paper's, the same for
the geometry and each variable, in percent of the extents: the diagonal of the bounding box for the geometry, max − min for a
variable.

${paper.counts}

Triangles left, and their share. The paper gives shares over both bounds together.

## The errors reached

*Bound* is in the variable's unit; the other columns are in percent of it. *Guaranteed*: the largest error that the
accounting allows for any point. *Judged*: the smallest bound of this variable at which the judge still
passes, all other bounds being as they are, to ${(100 / 128).toFixed(1)} %; *all together* is the judge's own ratio. Guaranteed
errors near 100 % and judged ones far below mean that the accounting overestimates.

${paper.errors}

## Figures 7 and 8

Drawn by the page in headless Chromium, reduced with tracked errors. The first variable is flat shaded with its edges, as in the paper.

${paperCases.map((one) => figure(one, samples.get(one.sample) as Surface)).join('\n\n')}

## What the geometric bound is relative to

The paper says "relative error bounds of 3 %" and not what the geometric one is relative to. Here it is the diagonal of the
bounding box, the length that corresponds to max − min of a variable. Other choices, every variable's bound being 3 % of its
range; *in mean edges*: the geometric bound in lengths of the mean edge of the original.

${reference}

The variables hold back most: without any bound of the geometry, few more triangles can go.

## Other surfaces

The same simulations on grids 3.8 times finer; the bunny of the npm package \`bunny\`, with curvature, height and a wave
(\`tests/peers/bunny.ts\`); a fractal terrain with height and temperature (\`tests/peers/surfaces_main.cpp\`). Bounds are
geometry/variables in percent; *judge* is its ratio, at most 1.

${other}

## Compared with other tools

\`npm run peers\` searches, for each surface and bound, the fewest triangles that meshoptimizer and VTK leave within the
bounds; that takes hours, so its results are on [a page of their own](peers.md). In short, *ratio* being Meshbound's
triangles (tracked) over those of the best peer, found with hindsight by means of the judge:

${peersSummary()}
`;
}

function figure({ sample, description, percents, drawn }: PaperCase, { mesh, units }: Surface): string {
  const levels = ['original', ...percents.map(String)];
  const range = (name: string) => {
    const variable = mesh.variables.find((candidate) => candidate.name === name);
    if (!variable) throw new Error(`${sample} has no variable ${name}.`);
    const [{ lowest, highest }] = spanOf(variable, mesh.triangles).components;
    return `${name}, ${shortNumber(lowest)} … ${shortNumber(highest)}${unitText(units[name])}`;
  };
  const title = (level: string) => (level === 'original' ? 'original' : `${level} %`);
  const cell = (level: string, name: string) =>
    `![${sample}, ${name}, ${title(level)}](evaluation/${pictureFile(sample, name, level)})`;
  const rows = levels.map((level) => `| ${[title(level), ...drawn.map((name) => cell(level, name))].join(' | ')} |`);
  const head = `| ${['', ...drawn.map(range)].join(' | ')} |\n| --- | --- | --- | --- |`;
  return `**${sample}**: ${description}; viridis from lowest to highest value\n\n${head}\n${rows.join('\n')}`;
}

/** The first table of the peers' page. */
function peersSummary(): string {
  const lines = readFileSync('docs/peers.md', 'utf8').split('\n');
  const first = lines.findIndex((line) => line.startsWith('| bounds'));
  const rest = lines.slice(first);
  return rest
    .slice(
      0,
      rest.findIndex((line) => !line.startsWith('|')),
    )
    .join('\n');
}
