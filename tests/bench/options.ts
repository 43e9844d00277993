import { existsSync } from 'node:fs';
import { dirname, resolve } from 'node:path';
import { parseArgs } from 'node:util';
import { type Size, sizes, variableSets } from './cases.ts';

/** Of both commands: what they measure, and the file that gets the tables, if any. */
interface Common {
  sizes: Size[];
  out: string | undefined;
}

export interface BenchOptions extends Common {
  variables: string[][];
  /** Instead of those that each size asks for. */
  rounds: number | undefined;
}

const common = {
  quick: { type: 'boolean', default: false },
  sizes: { type: 'string' },
  out: { type: 'string' },
} as const;

const quickSizes = '7k,100k';

/** The options of `npm run bench`; throws an error that names what cannot be. */
export function benchOptions(given: string[]): BenchOptions {
  const { values } = parseArgs({
    args: given,
    options: { ...common, variables: { type: 'string' }, rounds: { type: 'string' } },
  });
  const { quick } = values;
  return {
    sizes: sizesOf(values.sizes ?? (quick ? quickSizes : sizes.map(({ name }) => name).join(','))),
    variables: chosen('--variables', values.variables ?? (quick ? '7' : '0,2,7'), variableSets),
    rounds: values.rounds === undefined ? (quick ? 1 : undefined) : roundsOf(values.rounds),
    out: outOf(values.out),
  };
}

/** The options of `npm run bench:path`; throws an error that names what cannot be. */
export function pathOptions(given: string[]): Common {
  const { values } = parseArgs({ args: given, options: common });
  return {
    sizes: sizesOf(values.sizes ?? (values.quick ? quickSizes : '7k,100k,1m')),
    out: outOf(values.out),
  };
}

/** Reads the options of this program. Without them it ends: asked for help with the usage, else with what is wrong, too. */
export function optionsOr<Options>(usage: string, read: (given: string[]) => Options): Options {
  const given = process.argv.slice(2);
  if (given.includes('--help')) {
    console.log(usage);
    process.exit(0);
  }
  try {
    return read(given);
  } catch (error) {
    console.error(`${error instanceof Error ? error.message : error}\n\n${usage}`);
    process.exit(2);
  }
}

function sizesOf(wanted: string): Size[] {
  return chosen('--sizes', wanted, Object.fromEntries(sizes.map((size) => [size.name, size])));
}

function chosen<Thing>(option: string, wanted: string, things: Record<string, Thing>): Thing[] {
  return wanted.split(',').map((name) => {
    const thing = Object.hasOwn(things, name) ? things[name] : undefined;
    if (thing === undefined) throw new Error(`${option}: no "${name}". There are: ${Object.keys(things).join(', ')}.`);
    return thing;
  });
}

function roundsOf(text: string): number {
  const rounds = Number(text);
  if (!Number.isInteger(rounds) || rounds < 1) throw new Error(`--rounds: "${text}" is no whole number above zero.`);
  return rounds;
}

/** Before hours of measuring, not after. */
function outOf(path: string | undefined): string | undefined {
  if (path !== undefined && !existsSync(dirname(resolve(path)))) {
    throw new Error(`--out: there is no folder ${dirname(resolve(path))}.`);
  }
  return path;
}
