/** What the command says to the shell. Documented in docs/command-line.md. */
export const exitStatus = {
  done: 0,
  /** `verify` only: the reduced surface breaks a bound. */
  boundBroken: 1,
  /** A wrong command line, a file that cannot be read or written, or a mesh that cannot be reduced. */
  fault: 2,
  /** A mistake of this program. */
  internal: 3,
  /** Plus the number of the signal that ended the command: 130 after Ctrl-C. */
  signalled: 128,
} as const;
