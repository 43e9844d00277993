/** One sub-command. */
export interface Command {
  /** What `--help` shows. */
  help: string;
  /** Runs with the arguments behind the command's name; gives the exit status. */
  run(args: string[]): Promise<number>;
}
