import {
  embedSnippet,
  stateFragment,
  stateFromFragment,
  type ViewerState,
} from '../../element/attributes/viewer-state.ts';
import type { MeshboundViewer } from '../../element/meshbound-viewer.ts';

/** The address changes once nothing has changed for so long, in milliseconds: browsers allow few changes a second. */
const restBeforeWriting = 300;

/** Keeps the state of a viewer in the part of the page's address behind `#`, which no server gets to see. */
export class Link {
  #viewer: MeshboundViewer;
  /** What is open where the address says nothing. */
  #first: string | null = null;
  #timer: ReturnType<typeof setTimeout> | undefined;

  constructor(viewer: MeshboundViewer) {
    this.#viewer = viewer;
    addEventListener('hashchange', () => this.read());
  }

  /** Shows what the address says, or else the surface at `first`. */
  begin(first: string | null): void {
    this.#first = first;
    this.read();
  }

  read(): void {
    const state = stateFromFragment(location.hash);
    this.#viewer.state = { ...(this.#first ? { src: this.#first } : {}), ...state };
  }

  /** Writes the state into the address, soon. */
  update(): void {
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => this.#write(), restBeforeWriting);
  }

  /** The address that shows the same; null where the surface is a file of the user's, which no address reaches. */
  get address(): string | null {
    const { state } = this.#viewer;
    if (!state.src) return null;
    const link = new URL(location.href);
    link.hash = stateFragment(state);
    return link.href;
  }

  /** What to paste into a page of one's own; its surface can be reached from anywhere where it is here. */
  get snippet(): string {
    const { state } = this.#viewer;
    const absolute: ViewerState = { ...state, src: new URL(state.src ?? 'surface.vtp', document.baseURI).href };
    return embedSnippet(absolute, new URL('element/meshbound-viewer.js', document.baseURI).href);
  }

  #write(): void {
    const { session, state } = this.#viewer;
    // What is not open yet, or never was, keeps its address.
    if (session.state.opening || !session.state.surface) return;
    const { src, ...rest } = state;
    const shown = src && src !== this.#first ? state : src ? rest : {};
    const fragment = stateFragment(shown);
    const wanted = fragment ? `#${fragment}` : '';
    if (wanted !== location.hash) history.replaceState(null, '', wanted || location.pathname + location.search);
  }
}
