import { type ParseArgsConfig, parseArgs } from 'node:util';
import { UsageFault } from './fault.ts';

type Options = NonNullable<ParseArgsConfig['options']>;

/** What a command takes. */
export interface Signature<Known extends Options> {
  options: Known;
  /** The names of the arguments that are not options, for messages; all of them must be given. */
  positionals: readonly string[];
}

/** Node's parseArgs with our words. Throws a UsageFault for what the command does not take or lacks. */
export function parseArguments<Known extends Options>(
  args: string[],
  { options, positionals: wanted }: Signature<Known>,
) {
  const parsed = parse(args, options);
  const given = parsed.positionals.length;
  if (given < wanted.length) throw new UsageFault(`${wanted[given]} is missing.`);
  if (given > wanted.length) throw new UsageFault(`“${parsed.positionals[wanted.length]}” is one argument too many.`);
  return parsed;
}

function parse<Known extends Options>(args: string[], options: Known) {
  try {
    return parseArgs({ args, options, allowPositionals: true, strict: true });
  } catch (error) {
    // The first sentence says it; what follows is advice for programmers.
    if (error instanceof TypeError) throw new UsageFault(`${error.message.split(/\.\s|\.$/)[0]}.`);
    throw error;
  }
}

/** The value of an option that takes one of a few words. */
export function oneOf<Word extends string>(option: string, given: string, words: readonly Word[]): Word {
  const word = words.find((each) => each === given);
  if (!word) throw new UsageFault(`${option} cannot be “${given}”; it is ${words.join(' or ')}.`);
  return word;
}
