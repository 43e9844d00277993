import type { Way } from './path-table.ts';

declare global {
  interface Window {
    probe: {
      steps: Way['steps'];
      /** Forgets what was, and lets the way begin with the next input: a chosen file, a slider moved. */
      begin(): void;
      way(): Way;
      /** Whether the last surface that was made ready is in the picture. */
      isDrawn(): boolean;
    };
  }
}

/**
 * Runs in the page before anything else does. Notes when workers are asked and answer, what is uploaded to the graphics
 * card, and when a picture is there, without the page's knowing of it.
 */
export function probePage(): void {
  const steps: Way['steps'] = [];
  const pictures: Way['pictures'] = [];
  let start = 0;
  watchWorkers();
  watchGraphics();
  window.probe = {
    steps,
    begin() {
      steps.length = 0;
      pictures.length = 0;
      addEventListener('input', () => (start = performance.now()), { capture: true, once: true });
    },
    way: () => ({ start, steps, pictures }),
    isDrawn() {
      const ready = steps.findLast(({ name }) => name === 'prepare');
      const picture = pictures.at(-1);
      return ready === undefined || (picture !== undefined && picture.end > ready.end);
    },
  };

  function watchWorkers(): void {
    const { Worker } = window;
    window.Worker = class extends Worker {
      #asked: { name: string; start: number }[] = [];

      constructor(url: string | URL, options?: WorkerOptions) {
        super(url, options);
        this.addEventListener('message', ({ data }) => this.#answered(data));
      }

      #answered(data: { outcome?: { value?: Pick<Way['steps'][number], 'report'> } }): void {
        const asked = 'progress' in data ? undefined : this.#asked.shift();
        if (asked) steps.push({ ...asked, end: performance.now(), report: data.outcome?.value?.report });
      }

      override postMessage(message: unknown, options?: StructuredSerializeOptions | Transferable[]): void {
        this.#asked.push({ name: nameOf(message as Record<string, never>), start: performance.now() });
        super.postMessage(message, options as StructuredSerializeOptions);
      }
    };
  }

  function nameOf(message: { task?: { kind: string }; bytes?: unknown }): string {
    if (message.task) return message.task.kind;
    return message.bytes ? 'read' : 'prepare';
  }

  function watchGraphics(): void {
    const { bufferData, drawArrays } = WebGL2RenderingContext.prototype;
    WebGL2RenderingContext.prototype.bufferData = function (this: WebGL2RenderingContext, ...given: unknown[]) {
      const begun = performance.now();
      bufferData.apply(this, given as never);
      steps.push({ name: 'upload', start: begun, end: performance.now() });
    };
    WebGL2RenderingContext.prototype.drawArrays = function (mode: number, first: number, count: number) {
      const begun = performance.now();
      drawArrays.call(this, mode, first, count);
      // Reading a pixel waits until the graphics card is done.
      this.readPixels(0, 0, 1, 1, this.RGBA, this.UNSIGNED_BYTE, new Uint8Array(4));
      const end = performance.now();
      steps.push({ name: 'draw', start: begun, end });
      pictures.push({ triangles: count / 3, end });
    };
  }
}
