import { type ParseArgsConfig, parseArgs } from 'node:util';
import { foreign } from '../../formats/text/wording.ts';
import { UsageFault } from '../fault.ts';

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
    if (!(error instanceof TypeError)) throw error;
    // The first sentence says it; what follows is advice for programmers.
    throw new UsageFault(ambiguity(error.message, args, options) ?? `${foreign(error.message.split(/\.\s|\.$/)[0])}.`);
  }
}

/** Says how to write the value of an option that begins with a minus, where it is that what parseArgs stumbles over. */
function ambiguity(message: string, args: string[], options: Options): string | undefined {
  const [, given] = /^Option '(?:-\w, )?(--?[\w-]+)[^']*' argument is ambiguous/.exec(message) ?? [];
  if (!given) return undefined;
  const [name] = Object.entries(options).find(([, { short }]) => given === `-${short}`) ?? [given.slice(2)];
  const names = [`--${name}`, `-${options[name]?.short}`];
  const value = args.find((arg, i) => arg.startsWith('-') && names.includes(args[i - 1]));
  return `The value of ${given} is missing, or begins with a minus; the latter is written --${name}=${value ?? '-…'}.`;
}

/** The value of an option that takes one of a few words. */
export function oneOf<Word extends string>(option: string, given: string, words: readonly Word[]): Word {
  const word = words.find((each) => each === given);
  if (!word) throw new UsageFault(`${option} cannot be “${given}”; it is ${words.join(' or ')}.`);
  return word;
}
