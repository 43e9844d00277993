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

/** What to do about a variable that is in the way. */
function advice(error: FormatError | MeshboundError): string {
  if (error instanceof MeshboundError) {
    return error.code === 'non_finite_value' && error.variable ? unboundedAdvice(error.variable) : '';
  }
  const inTheWay = error.code === 'not_finite' && error.where !== 'position';
  return inTheWay ? ` To leave the variable out: --exclude "${error.where}".` : '';
}

/** The two ways out where a variable can have no bound. */
export function unboundedAdvice(name: string): string {
  return ` To carry it along as it is, with nothing guaranteed of it: --bound "${name}=free". To leave it out: --exclude "${name}".`;
}
