import { type ChildProcess, spawn } from 'node:child_process';
import { createInterface } from 'node:readline';

/** A program that answers each line of its standard input with one line of its standard output. */
export class LineServer {
  private readonly process: ChildProcess;
  private readonly answers: AsyncIterator<string>;

  constructor(
    private readonly command: string,
    programArguments: string[] = [],
  ) {
    this.process = spawn(command, programArguments, { stdio: ['pipe', 'pipe', 'inherit'] });
    this.process.on('error', () => {}); // the answer that does not come says so
    if (!this.process.stdout) throw new Error(`${command} has no standard output.`);
    this.answers = createInterface({ input: this.process.stdout })[Symbol.asyncIterator]();
  }

  /** Throws where the answer begins with "error", or the program ends without one. */
  async ask(request: string): Promise<string> {
    this.process.stdin?.write(`${request}\n`);
    const { value, done } = await this.answers.next();
    if (done) throw new Error(`${this.command} ended without an answer to: ${request}`);
    if (value.startsWith('error')) throw new Error(`${this.command}: ${value.slice('error '.length)} (${request})`);
    return value;
  }

  close(): void {
    this.process.stdin?.end();
  }
}
