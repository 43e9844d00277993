import { withoutRegionNotes } from '../../formats/regions/region-notes.ts';
import type { Command } from '../command.ts';
import { exitStatus } from '../exit-status.ts';
import { requireWritable, StagedFiles } from '../files/staged-files.ts';
import { encodeSurface, openSurface, outputFormat } from '../files/surface-files.ts';
import { interruptible } from '../interruption.ts';
import { parseArguments } from '../options/arguments.ts';
import { without } from '../options/exclude.ts';
import { parseWeld, weldHelp } from '../options/weld-argument.ts';
import { sayNotes } from '../output/notes.ts';

const help = `Writes a surface in another format, with every variable that the format holds, and cell data of whole numbers.

Usage: meshbound convert IN OUT

The format of IN is seen from its content, that of OUT is given by its ending: .vtp, .vtk, .ply, .glb, .obj or .stl,
and .gz behind any of them. What OUT cannot hold is said on standard error.

Options:
  --variables FILE.csv    more variables of IN: names in the first line, then a line for each point
  ${weldHelp}
  --exclude NAME          leave a variable out, as often as needed
  --quiet                 say nothing but errors

Examples:
  meshbound convert engine.vtk engine.vtp
  meshbound convert scan.ply scan.glb
  meshbound convert part.stl part.vtp --variables part.csv
  meshbound convert part.vtp part.glb.gz`;

async function run(args: string[]): Promise<number> {
  const { values, positionals } = parseArguments(args, {
    options: {
      variables: { type: 'string' },
      weld: { type: 'string' },
      exclude: { type: 'string', multiple: true, default: [] as string[] },
      quiet: { type: 'boolean' },
    },
    positionals: ['IN', 'OUT'],
  });
  const [input, output] = positionals;
  const weld = parseWeld(values.weld);
  outputFormat(output);
  await requireWritable([output]);
  const surface = without(values.exclude, await openSurface(input, values.variables, { weld }));
  const losses = await interruptible((signal) =>
    StagedFiles.complete(signal, async (files) => {
      const { bytes, losses } = await encodeSurface(output, surface.mesh, { ...surface, cellData: surface.regions });
      await files.write(output, bytes);
      return losses;
    }),
  );
  if (!values.quiet) {
    sayNotes(input, withoutRegionNotes(surface.notes, surface.regions));
    sayNotes(output, losses);
  }
  return exitStatus.done;
}

export const convert: Command = { help, run };
