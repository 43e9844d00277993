import { type ErrorCode, MeshboundError } from '../../wasm/errors.ts';
import { FormatError } from '../formats/format-error.ts';

/** What is the user's to mend: a wrong command line, or something about a file. The message is all that is shown. */
export class Fault extends Error {
  constructor(message: string) {
    super(message);
    this.name = 'Fault';
  }
}

/** A wrong command line: shown with where to look up the right one. */
export class UsageFault extends Fault {}

/** What is no fault of a mesh. */
const ours: ReadonlySet<ErrorCode> = new Set<ErrorCode>(['internal', 'worker_failed']);

const systemFaults: Record<string, string> = {
  ENOENT: 'there is no such file or folder',
  EACCES: 'permission denied',
  EPERM: 'permission denied',
  EISDIR: 'this is a folder, not a file',
  ENOTDIR: 'part of the path is not a folder',
  ENOSPC: 'there is no space left',
  EROFS: 'the file system can only be read',
  ERR_FS_FILE_TOO_LARGE: 'the file is larger than can be read at once (2 GB)',
};

/** An error that came up over a file as a Fault that begins with the file's name; mistakes of this program as they are. */
export function faultOf(file: string, error: unknown): unknown {
  if (error instanceof MeshboundError && ours.has(error.code)) return error;
  if (error instanceof FormatError || error instanceof MeshboundError) {
    return new Fault(`${file}: ${error.message}${advice(error)}`);
  }
  const { code, syscall } = (error ?? {}) as NodeJS.ErrnoException;
  if (code && (syscall || code in systemFaults)) return new Fault(`${file}: ${systemFaults[code] ?? code}.`);
  return error;
}

/** What to do about a variable that only reading and verifying can deal with. */
function advice(error: FormatError | MeshboundError): string {
  const inTheWay = error.code === 'not_finite' || error.code === 'non_finite_value';
  const name = error instanceof FormatError ? error.where : error.variable;
  if (!inTheWay || name === undefined || name === 'position') return '';
  const free = error instanceof MeshboundError ? ` To carry it along without a bound: --bound "${name}=free".` : '';
  return `${free} To leave the variable out: --exclude "${name}".`;
}
