import type { ReactiveController, ReactiveControllerHost } from 'lit';

/** Takes files dropped anywhere on the page. */
export class FileDrop implements ReactiveController {
  /** Whether files are held over the page right now. */
  hovering = false;
  #host: ReactiveControllerHost;
  #dropped: (files: File[]) => void;

  constructor(host: ReactiveControllerHost, dropped: (files: File[]) => void) {
    this.#host = host;
    this.#dropped = dropped;
    host.addController(this);
  }

  hostConnected(): void {
    addEventListener('dragover', this.#over);
    addEventListener('dragleave', this.#leave);
    addEventListener('drop', this.#drop);
  }

  hostDisconnected(): void {
    removeEventListener('dragover', this.#over);
    removeEventListener('dragleave', this.#leave);
    removeEventListener('drop', this.#drop);
  }

  #over = (event: DragEvent): void => {
    if (!event.dataTransfer?.types.includes('Files')) return;
    // Without this the browser would open the file itself.
    event.preventDefault();
    this.#hover(true);
  };

  #leave = (event: DragEvent): void => {
    // Only leaving the window counts; entering a child of the page does not.
    if (event.relatedTarget === null) this.#hover(false);
  };

  #drop = (event: DragEvent): void => {
    const files = Array.from(event.dataTransfer?.files ?? []);
    this.#hover(false);
    if (files.length === 0) return;
    event.preventDefault();
    this.#dropped(files);
  };

  #hover(hovering: boolean): void {
    if (hovering === this.hovering) return;
    this.hovering = hovering;
    this.#host.requestUpdate();
  }
}
