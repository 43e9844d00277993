import { css, html, LitElement } from 'lit';
import type { Sample } from '../session/services.ts';
import type { Method, OpenSurface, Session } from '../session/session.ts';
import type { BoundChange } from './bounds-panel.ts';
import './bounds-panel.ts';
import { controlsStyle } from '../element/controls-style.ts';
import { reducedFileName } from '../element/file-name.ts';
import { FileDrop } from './file-drop.ts';
import '../element/notices.ts';
import { isMeasured } from '../element/promise-words.ts';
import type { SavedFormat } from './result-bar.ts';
import './result-bar.ts';
import { save } from '../element/save.ts';
import type { Stage } from '../element/stage.ts';
import '../element/stage.ts';
import './toolbar.ts';
import { firstView, settingsFor, type ViewSettings } from '../element/view-settings.ts';

/** The whole page around one session. */
export class App extends LitElement {
  static override properties = {
    session: { attribute: false },
    samples: { attribute: false },
    settings: { state: true },
  };

  static override styles = [
    controlsStyle,
    css`
      :host {
        display: grid;
        grid-template: 'toolbar toolbar' auto 'bounds stage' minmax(0, 1fr) 'result result' auto / 320px minmax(0, 1fr);
        height: 100dvh;
      }
      meshbound-toolbar {
        grid-area: toolbar;
        background: var(--panel);
        border-bottom: 1px solid var(--line);
      }
      .bounds {
        grid-area: bounds;
        overflow-y: auto;
        background: var(--panel);
        border-right: 1px solid var(--line);
      }
      .stage {
        grid-area: stage;
        position: relative;
      }
      meshbound-stage {
        height: 100%;
      }
      meshbound-notices {
        position: absolute;
        z-index: 1;
        top: 50px;
        left: 50%;
        width: min(620px, 100% - 24px);
        transform: translateX(-50%);
      }
      meshbound-result-bar {
        grid-area: result;
        background: var(--panel);
        border-top: 1px solid var(--line);
      }
      .drop {
        position: fixed;
        z-index: 3;
        inset: 8px;
        display: grid;
        place-items: center;
        background: var(--veil);
        border: 2px dashed var(--accent);
        border-radius: var(--radius);
        pointer-events: none;
      }
      .drop:not(.hovering) {
        display: none;
      }
      @media (max-width: 800px) {
        :host {
          grid-template: 'toolbar' auto 'stage' min(150vw, 70dvh) 'result' auto 'bounds' auto / minmax(0, 1fr);
          height: auto;
        }
        .bounds {
          border-right: none;
          border-top: 1px solid var(--line);
        }
      }
    `,
  ];

  declare session: Session;
  declare samples: readonly Sample[];
  declare settings: ViewSettings;

  constructor() {
    super();
    this.samples = [];
    this.settings = firstView;
  }

  #shown: OpenSurface | null = null;
  #drop = new FileDrop(this, (file) => this.#openFile(file));

  override connectedCallback(): void {
    super.connectedCallback();
    this.session.addEventListener('change', this.#sessionChanged);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.session.removeEventListener('change', this.#sessionChanged);
  }

  override render() {
    const { surface, bounds, method, result, opening, progress, cancelled, notices } = this.session.state;
    const measured = result !== null && isMeasured(result);
    return html`
      <meshbound-toolbar
        role="banner"
        .samples=${this.samples}
        .opening=${opening}
        .surface=${surface}
        .bounds=${bounds}
        .settings=${this.settings}
        @open-file=${({ detail }: CustomEvent<File>) => this.#openFile(detail)}
        @open-sample=${({ detail }: CustomEvent<Sample>) => this.openSample(detail)}
        @view-change=${({ detail }: CustomEvent<ViewSettings>) => (this.settings = detail)}
        @fit=${() => this.renderRoot.querySelector<Stage>('meshbound-stage')?.fit()}
      ></meshbound-toolbar>
      <div class="bounds" role="region" aria-label="Bounds">
        <meshbound-bounds-panel
          .surface=${surface}
          .bounds=${bounds}
          .method=${method}
          .report=${result?.report ?? null}
          .measured=${measured}
          @bounds-change=${({ detail }: CustomEvent<BoundChange>) => this.#changeBounds(detail)}
          @method-change=${({ detail }: CustomEvent<Method>) => this.session.setMethod(detail)}
        ></meshbound-bounds-panel>
      </div>
      <div class="stage" role="main">
        <meshbound-stage
          .surface=${surface}
          .result=${result}
          .reducing=${progress !== null}
          .settings=${this.settings}
          @stage-fault=${({ detail }: CustomEvent<string>) => this.session.report(detail, { lasting: true })}
        ></meshbound-stage>
        <meshbound-notices
          .notices=${notices}
          @dismiss=${({ detail }: CustomEvent<number>) => this.session.dismiss(detail)}
        ></meshbound-notices>
      </div>
      <meshbound-result-bar
        role="contentinfo"
        .report=${result?.report ?? null}
        .measured=${measured}
        .opening=${opening}
        .progress=${progress}
        .cancelled=${cancelled}
        @cancel=${() => this.session.cancel()}
        @reduce-again=${() => this.session.reduceAgain()}
        @save=${({ detail }: CustomEvent<SavedFormat>) => this.#save(detail)}
      ></meshbound-result-bar>
      <div class="drop ${this.#drop.hovering ? 'hovering' : ''}">Drop to open</div>
    `;
  }

  openSample(sample: Sample): void {
    void this.session.openSample(sample);
  }

  #openFile(file: File): void {
    void this.session.openFile(file);
  }

  #changeBounds(change: BoundChange): void {
    if ('all' in change) this.session.setAllBounds(change.all);
    else this.session.setBound(change.variable, change.setting);
  }

  async #save(format: SavedFormat): Promise<void> {
    const { surface, result } = this.session.state;
    if (!surface || !result) return;
    try {
      await save(result.mesh, surface.labels, format, reducedFileName(surface.name, format));
    } catch (error) {
      this.session.report(error);
    }
  }

  /** Another surface has other variables. */
  #sessionChanged = (): void => {
    const { surface } = this.session.state;
    if (surface !== this.#shown && surface) this.settings = settingsFor(surface, this.settings);
    this.#shown = surface;
    this.requestUpdate();
  };
}

customElements.define('meshbound-app', App);
