import { css, html, LitElement } from 'lit';
import '../element/index.ts';
import type { WantedView } from '../element/view-settings.ts';
import type { Method } from '../session/session.ts';
import type { BoundChange } from './bounds-panel.ts';
import './bounds-panel.ts';
import { controlsStyle } from '../element/controls-style.ts';
import { isMeasured } from '../element/promise-words.ts';
import { tokens } from '../element/tokens.ts';
import { FileDrop } from './file-drop.ts';
import type { SavedFormat } from './result-bar.ts';
import './result-bar.ts';
import type { Sample } from './samples.ts';
import './toolbar.ts';

/** The whole page around one viewer. */
export class App extends LitElement {
  static override properties = {
    samples: { attribute: false },
  };

  static override styles = [
    tokens,
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
      meshbound-viewer {
        grid-area: stage;
        aspect-ratio: auto;
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

  declare samples: readonly Sample[];

  /** What shows the surfaces; everything else on the page drives it. */
  readonly viewer = document.createElement('meshbound-viewer');
  #drop = new FileDrop(this, (file) => this.#openFile(file));

  constructor() {
    super();
    this.samples = [];
    this.viewer.setAttribute('role', 'main');
    this.viewer.session.addEventListener('change', () => this.requestUpdate());
  }

  override render() {
    const { session } = this.viewer;
    const { surface, bounds, method, reduced, opening, progress, cancelled } = session.state;
    const result = reduced?.result ?? null;
    const measured = result !== null && isMeasured(result);
    return html`
      <meshbound-toolbar
        role="banner"
        .samples=${this.samples}
        .opening=${opening}
        .surface=${surface}
        .bounds=${bounds}
        .settings=${this.viewer.settings}
        @open-file=${({ detail }: CustomEvent<File>) => this.#openFile(detail)}
        @open-sample=${({ detail }: CustomEvent<Sample>) => this.openSample(detail)}
        @view-change=${({ detail }: CustomEvent<Partial<WantedView>>) => this.#changeView(detail)}
        @fit=${() => this.viewer.fit()}
      ></meshbound-toolbar>
      <div class="bounds" role="region" aria-label="Bounds">
        <meshbound-bounds-panel
          .surface=${surface}
          .bounds=${bounds}
          .method=${method}
          .report=${result?.report ?? null}
          .measured=${measured}
          @bounds-change=${({ detail }: CustomEvent<BoundChange>) => this.#changeBounds(detail)}
          @method-change=${({ detail }: CustomEvent<Method>) => session.setMethod(detail)}
        ></meshbound-bounds-panel>
      </div>
      ${this.viewer}
      <meshbound-result-bar
        role="contentinfo"
        .report=${result?.report ?? null}
        .measured=${measured}
        .opening=${opening}
        .progress=${progress}
        .cancelled=${cancelled}
        @cancel=${() => session.cancel()}
        @reduce-again=${() => session.reduceAgain()}
        @save=${({ detail }: CustomEvent<SavedFormat>) => this.viewer.save(detail)}
      ></meshbound-result-bar>
      <div class="drop ${this.#drop.hovering ? 'hovering' : ''}">Drop to open</div>
    `;
  }

  openSample({ address }: Sample): void {
    this.viewer.src = address;
  }

  #openFile(file: File): void {
    void this.viewer.open(file);
  }

  #changeView(wanted: Partial<WantedView>): void {
    Object.assign(this.viewer, wanted);
    this.requestUpdate();
  }

  #changeBounds(change: BoundChange): void {
    const { session } = this.viewer;
    if ('all' in change) session.setAllBounds(change.all);
    else session.setBound(change.variable, change.setting);
  }
}

customElements.define('meshbound-app', App);
