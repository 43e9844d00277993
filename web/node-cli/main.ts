#!/usr/bin/env node
import { version } from '../../package.json';
import { printable } from '../formats/text/wording.ts';
import type { Command } from './command.ts';
import { exitStatus } from './exit-status.ts';
import { Fault, UsageFault } from './fault.ts';
import { Interrupted } from './interruption.ts';

/** Each loaded when it is asked for. */
const commands: Record<string, () => Promise<Command>> = {
  inspect: async () => (await import('./commands/inspect.ts')).inspect,
  reduce: async () => (await import('./commands/reduce.ts')).reduce,
  verify: async () => (await import('./commands/verify.ts')).verify,
  convert: async () => (await import('./commands/convert.ts')).convert,
};

const help = `Reduces triangle meshes that carry data, and proves how much it changed them.

Usage: meshbound COMMAND …

Commands:
  inspect FILE                               what a surface is like, and what its variables span
  reduce IN -o OUT --bound NAME=1% …         fewer triangles, every error within its bound
  verify ORIGINAL REDUCED --bound NAME=1% …  an independent check of the bounds
  convert IN OUT                             from one format to another

  meshbound COMMAND --help    options and examples of a command
  meshbound --version         the version

Examples:
  meshbound inspect engine.vtp
  meshbound reduce engine.vtp -o small.vtp --bound position=1% --bound "*=3%"
  meshbound verify engine.vtp small.vtp --bound position=1% --bound "*=3%"

Formats: VTP, legacy VTK, PLY, GLB, OBJ and STL; .gz of any of them.

Exit status: 0 done; 1 a bound is broken (verify); 2 a wrong command line or file; 3 a mistake of this program;
128 plus the signal's number when interrupted, 130 after Ctrl-C.`;

async function run([name, ...args]: string[]): Promise<number> {
  if (name === '--version') {
    console.log(version);
    return exitStatus.done;
  }
  if (name === '--help' || name === '-h') {
    console.log(help);
    return exitStatus.done;
  }
  if (name === undefined) throw new UsageFault('A command is missing.');
  if (!Object.hasOwn(commands, name)) {
    throw new UsageFault(`There is no command “${name}”; the commands are ${Object.keys(commands).join(', ')}.`);
  }
  const command = await commands[name]();
  if (args.includes('--help') || args.includes('-h')) {
    console.log(command.help);
    return exitStatus.done;
  }
  return command.run(args);
}

/** Says what went wrong on standard error; gives the exit status. */
function complain(error: unknown, [name = '']: string[]): number {
  if (error instanceof Interrupted) {
    console.error(`meshbound: ${error.message}`);
    return exitStatus.signalled + error.signalNumber;
  }
  if (error instanceof Fault) {
    console.error(`meshbound: ${printable(error.message)}`);
    const command = Object.hasOwn(commands, name) ? `${name} ` : '';
    if (error instanceof UsageFault) console.error(`Try: meshbound ${command}--help`);
    return exitStatus.fault;
  }
  console.error(`meshbound: this should not have happened.\n${error instanceof Error ? error.stack : error}`);
  return exitStatus.internal;
}

// Whoever reads our output may stop reading (a pipe into head): then there is nothing more to say.
process.stdout.on('error', (error: NodeJS.ErrnoException) =>
  process.exit(error.code === 'EPIPE' ? exitStatus.done : exitStatus.fault),
);

const args = process.argv.slice(2);
process.exitCode = await run(args).catch((error) => {
  const status = complain(error, args);
  // The reduction would go on until it looks whether it is still wanted.
  if (error instanceof Interrupted) process.exit(status);
  return status;
});
