import type { WriteStream } from 'node:tty';

const width = 40;

/** A bar on a terminal that fills from 0 to 1, drawn anew only when it looks different. */
export class ProgressBar {
  private readonly terminal: WriteStream;
  private drawn = '';

  constructor(terminal: WriteStream) {
    this.terminal = terminal;
  }

  show(progress: number): void {
    const filled = Math.round(progress * width);
    const percent = String(Math.floor(100 * progress)).padStart(3);
    const bar = `[${'#'.repeat(filled)}${'.'.repeat(width - filled)}] ${percent} %`;
    if (bar !== this.drawn) this.terminal.write(`\r${bar}`);
    this.drawn = bar;
  }

  clear(): void {
    if (this.drawn) this.terminal.write(`\r${' '.repeat(this.drawn.length)}\r`);
    this.drawn = '';
  }
}
