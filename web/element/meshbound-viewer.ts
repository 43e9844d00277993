import { css, html, LitElement, nothing, type PropertyValues } from 'lit';
import { inspect, reduce } from '../../wasm/index.ts';
import type { Report } from '../../wasm/types.ts';
import type { ValueColormap } from '../colour/colormaps.ts';
import type { Format } from '../formats/surface.ts';
import { asBounds } from '../session/bound-setting.ts';
import { boundsText, readBounds } from '../session/bound-text.ts';
import { fetchBytes } from '../session/fetch-bytes.ts';
import { readInWorker } from '../session/read.ts';
import { Session, type SessionState } from '../session/session.ts';
import { reducedFileName } from './file-name.ts';
import './notices.ts';
import { save } from './save.ts';
import type { Stage } from './stage.ts';
import './stage.ts';
import { tokens } from './tokens.ts';
import { firstView, type Quantity, sameView, settingsFor, type ViewSettings } from './view-settings.ts';

/**
 * A surface and its reduction within proved bounds, side by side.
 *
 * @tag meshbound-viewer
 * @fires load - A surface is open: `{ name, variables }`.
 * @fires reduce - A reduction has ended well: its report.
 * @fires progress - `{ progress }`, 0…1.
 * @fires error - `{ code, message }`; what was shown before stays.
 */
export class MeshboundViewer extends LitElement {
  static override properties = {
    // Setting the same address again loads it again.
    src: { hasChanged: () => true },
    bounds: { noAccessor: true },
    variable: {},
    component: {},
    show: {},
    colormap: {},
    edges: { type: Boolean },
    unlinked: { type: Boolean },
    alt: {},
  };

  static override styles = [
    tokens,
    css`
      :host {
        display: block;
        position: relative;
        min-height: 120px;
        aspect-ratio: 2;
      }
      :host([hidden]) {
        display: none;
      }
      meshbound-stage {
        position: absolute;
        inset: 0;
      }
      meshbound-notices {
        position: absolute;
        z-index: 1;
        top: 50px;
        left: 50%;
        width: min(620px, 100% - 24px);
        transform: translateX(-50%);
      }
    `,
  ];

  /** The address of a surface: PLY, VTP, legacy VTK, glTF, OBJ or STL. */
  declare src: string | null;
  /** What the surfaces are coloured by: a variable, `position` among them. Default: the first that varies. */
  declare variable: string | null;
  /** Which component of a vector: `magnitude`, or what it is called (x, y, z, or the name in the file). */
  declare component: string | null;
  /** `value`, `error` (as a share of the bound) or `signed-error`. */
  declare show: Quantity | null;
  /** The map for values; errors have maps of their own. */
  declare colormap: ValueColormap | null;
  /** Draws the edges of the triangles. */
  declare edges: boolean;
  /** A camera for each side instead of one for both. */
  declare unlinked: boolean;
  /** What the surface is, for those who cannot see it. */
  declare alt: string | null;

  /** What is open, asked for and reached; for the page that is built around the element. @internal */
  readonly session = new Session({ inspect, reduce, read: readInWorker, fetchBytes });
  /** The same object until something in it changes, so that nothing is painted anew for nothing. */
  #settings = firstView;
  /** What the last change of the session was compared with. */
  #seen: SessionState = this.session.state;

  constructor() {
    super();
    this.src = null;
    this.variable = null;
    this.component = null;
    this.show = null;
    this.colormap = null;
    this.edges = false;
    this.unlinked = false;
    this.alt = null;
    this.session.addEventListener('change', () => this.#sessionChanged());
  }

  /** The bounds in force, as text: `position: 1%; pressure: 3%; velocity: 0.2`. What cannot be a bound is refused. */
  get bounds(): string {
    return boundsText(asBounds(this.session.state.bounds));
  }

  set bounds(text: string | null) {
    try {
      this.session.wantBounds(text === null ? null : readBounds(text));
    } catch (error) {
      this.session.report(error, { lasting: true });
    }
  }

  /** What the last reduction reached; null where there is none. */
  get report(): Report | null {
    return this.session.state.result?.report ?? null;
  }

  /** How the surfaces are looked at: what is asked for, as far as the surface has it. @internal */
  get settings(): ViewSettings {
    const settings = settingsFor(this.session.state.surface, this);
    if (!sameView(settings, this.#settings)) this.#settings = settings;
    return this.#settings;
  }

  /** Opens a file of the user's. */
  open(file: File): Promise<void> {
    return this.session.openFile(file);
  }

  /** Starts the reduction anew. */
  reduce(): void {
    this.session.reduceAgain();
  }

  /** Stops what is running; the last result stays. */
  abort(): void {
    this.session.cancel();
  }

  /** Brings the whole surface into view. */
  fit(): void {
    this.#stage?.fit();
  }

  /** Offers the reduced surface as a download. */
  async save(format: Format): Promise<void> {
    const { surface, result } = this.session.state;
    if (!surface || !result) return;
    try {
      await save(result.mesh, surface.labels, format, reducedFileName(surface.name, format));
    } catch (error) {
      this.session.report(error);
    }
  }

  get #stage(): Stage | null {
    return this.renderRoot.querySelector<Stage>('meshbound-stage');
  }

  override willUpdate(changed: PropertyValues<this>): void {
    if (changed.has('src') && this.src) void this.session.openAddress(this.src);
  }

  override render() {
    const { surface, result, progress, notices } = this.session.state;
    return html`
      <meshbound-stage
        role="group"
        aria-label=${this.alt ?? (surface?.name || nothing)}
        exportparts="pane, caption, legend, legend-title, legend-bar, legend-ticks, canvas"
        .surface=${surface}
        .result=${result}
        .reducing=${progress !== null}
        .settings=${this.settings}
        @stage-fault=${({ detail }: CustomEvent<string>) => this.session.report(detail, { lasting: true })}
      ></meshbound-stage>
      <meshbound-notices
        exportparts="notice"
        .notices=${notices}
        @dismiss=${({ detail }: CustomEvent<number>) => this.session.dismiss(detail)}
      ></meshbound-notices>
    `;
  }

  #sessionChanged(): void {
    const [before, now] = [this.#seen, this.session.state];
    this.#seen = now;
    this.requestUpdate();
    if (now.surface && now.surface !== before.surface) {
      const { name, variables } = now.surface;
      this.#fire('load', { name, variables });
    }
    if (now.progress !== null && now.progress !== before.progress) this.#fire('progress', { progress: now.progress });
    if (now.result && now.result !== before.result) this.#fire('reduce', now.result.report);
    for (const { kind, code, text } of now.notices.filter((notice) => !before.notices.includes(notice))) {
      if (kind === 'error') this.#fire('error', { code, message: text });
    }
  }

  #fire(name: string, detail: unknown): void {
    this.dispatchEvent(new CustomEvent(name, { detail }));
  }
}
