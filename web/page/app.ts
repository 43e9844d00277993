import { css, html, LitElement } from 'lit';
import { reduce, verify } from '../../wasm/index.ts';
import { download, type SavedKind, savedKinds } from '../element/saving/download.ts';
import { BoundsCurve } from '../session/bounds/bounds-curve.ts';
import '../element/index.ts';
import type { WantedView } from '../element/attributes/view-settings.ts';
import { stateFromJson, stateJson } from '../element/attributes/viewer-state.ts';
import { savedFileName } from '../element/saving/file-name.ts';
import { surfaceAmong } from '../formats/surface-among.ts';
import { type Keeping, nothingKept } from '../session/constraints/keeping.ts';
import type { Method } from '../session/constraints/method.ts';
import { messageOf } from '../session/reading/failure.ts';
import type { Reduced } from '../session/session-state.ts';
import { Verifying } from '../session/verifying.ts';
import type { ViewDirection } from '../viewer/linked-cameras.ts';
import type { BoundChange } from './bounds/bounds-panel.ts';
import './bounds/bounds-panel.ts';
import { keepingText, type WantedKeeping } from '../element/attributes/keeping-attributes.ts';
import { controlsStyle } from '../element/controls/controls-style.ts';
import { isMeasured } from '../element/result/guarantee-words.ts';
import { tokens } from '../element/tokens.ts';
import { FileDrop } from './toolbar/file-drop.ts';
import '../element/result/result-bar.ts';
import '../element/controls/levels-panel.ts';
import { Link } from './toolbar/link.ts';
import type { MenuItem } from './toolbar/menu.ts';
import './toolbar/menu.ts';

import type { Sample } from './toolbar/samples.ts';
import type { Toolbar } from './toolbar/toolbar.ts';
import './toolbar/toolbar.ts';
import type { KeySheet } from './toolbar/key-sheet.ts';
import './toolbar/key-sheet.ts';
import { english } from '../words/english.ts';
import { pageEnglish } from '../words/page-english.ts';

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
        grid-template: 'toolbar toolbar' auto 'bounds stage' minmax(0, 1fr) 'bounds levels' auto 'result result' auto / 320px minmax(0, 1fr);
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
      meshbound-levels-panel {
        grid-area: levels;
        background: var(--panel);
        border-top: 1px solid var(--line);
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
          /* All of the stage is to be seen, between the toolbar and the result, for which there is room whatever it says. */
          --free: max(320px, 100dvh - var(--toolbar-height, 0px) - 140px);
          grid-template: 'toolbar' auto 'stage' min(150vw, 70dvh, var(--free)) 'levels' auto 'bounds' auto 'result' auto / minmax(0, 1fr);
          height: auto;
        }
        /* In sight while a bound moves, whatever it says, and nothing moves with it. */
        meshbound-result-bar {
          --sentence-lines: 3;
          position: sticky;
          z-index: 1;
          bottom: 0;
          /* On a layer of its own: on one with the captions, Chromium takes the canvas below them for hidden. */
          will-change: transform;
        }
        .bounds {
          border-right: none;
          border-top: 1px solid var(--line);
        }
      }
      /* Where little is to be seen, as on a phone on its side or at 200 %, the surfaces have it. */
      @media (max-width: 800px) and (max-height: 500px) {
        :host {
          --free: max(200px, 100dvh - var(--toolbar-height, 0px));
        }
        meshbound-result-bar {
          position: static;
        }
      }
    `,
  ];

  declare samples: readonly Sample[];

  /** What shows the surfaces; everything else on the page drives it. */
  readonly viewer = document.createElement('meshbound-viewer');
  #curve = new BoundsCurve(reduce);
  #verifying = new Verifying(verify);
  /** Whether the chart is to be seen: nothing is measured for nobody. */
  #charted = false;
  /** The place on the original that is pinned. */
  #pinned: readonly number[] | null = null;
  #link = new Link(this.viewer);
  /** How much of the window the toolbar takes, for the style. */
  #toolbarSize = new ResizeObserver(([{ borderBoxSize }]) => {
    this.style.setProperty('--toolbar-height', `${borderBoxSize[0].blockSize}px`);
  });
  #drop = new FileDrop(this, (files) => this.#openFiles(files));

  constructor() {
    super();
    this.samples = [];
    this.viewer.setAttribute('role', 'main');
    this.viewer.levels.addEventListener('change', () => this.#changed());
    this.viewer.session.addEventListener('change', () => {
      this.#followCurve();
      this.#changed();
    });
    this.#curve.addEventListener('change', () => this.requestUpdate());
    this.#verifying.addEventListener('change', () => this.requestUpdate());
    this.viewer.addEventListener('pin', (event) => {
      this.#pinned = (event as CustomEvent).detail.place;
      this.requestUpdate();
    });
    this.viewer.addEventListener('camera-change', () => this.#link.update());
    this.addEventListener('bound-settled', () => this.viewer.session.settleBounds());
    addEventListener('keydown', this.#pressKey);
  }

  /** Shows what the page's address says, or else the first sample. */
  begin(): void {
    this.#link.begin(this.samples[0]?.address ?? null);
  }

  override firstUpdated(): void {
    const toolbar = this.renderRoot.querySelector('meshbound-toolbar');
    if (toolbar) this.#toolbarSize.observe(toolbar);
  }

  override render() {
    return html`
      ${this.#toolbar()} ${this.#boundsPanel()} ${this.viewer} ${this.#levelsPanel()} ${this.#resultBar()}
      <meshbound-key-sheet></meshbound-key-sheet>
      <div class="drop ${this.#drop.hovering ? 'hovering' : ''}">${pageEnglish.page.drop}</div>
    `;
  }

  #toolbar() {
    const { opening, surface, bounds } = this.viewer.session.state;
    return html`<meshbound-toolbar
      role="banner"
      .samples=${this.samples}
      .opening=${opening}
      .surface=${surface}
      .bounds=${bounds}
      .settings=${this.viewer.settings}
      @open-files=${({ detail }: CustomEvent<File[]>) => this.#openFiles(detail)}
      @open-sample=${({ detail }: CustomEvent<Sample>) => this.#openSample(detail)}
      @view-change=${({ detail }: CustomEvent<Partial<WantedView>>) => this.#set(detail)}
      @fit=${() => this.viewer.fit()}
      @look-from=${({ detail }: CustomEvent<ViewDirection>) => this.viewer.lookFrom(detail)}
    >
      ${this.#shareMenu()}
      <button aria-label=${pageEnglish.keys.title} title=${pageEnglish.keys.hint} @click=${() => this.#toggleKeys()}>
        ${pageEnglish.keys.sign}
      </button>
    </meshbound-toolbar>`;
  }

  /** The result at hand, whether it is provisional or not. */
  get #result(): Reduced['result'] | null {
    return this.viewer.shown?.result ?? null;
  }

  get #isMeasured(): boolean {
    return this.#result !== null && isMeasured(this.#result);
  }

  #boundsPanel() {
    const { session } = this.viewer;
    const { surface, bounds, canUndo, canRedo, method, keeping, reduced, progress } = session.state;
    const { shown, standing } = this.viewer;
    const result = shown?.result ?? null;
    const isOfOthers = shown !== null && (standing !== 'asked' || this.viewer.levels.shown !== null);
    return html`<div class="bounds" role="region" aria-label=${english.bounds.title}>
      <meshbound-bounds-panel
        .surface=${surface}
        .bounds=${bounds}
        .method=${method}
        .keeping=${keeping}
        .pinned=${this.#pinned}
        .report=${result?.report ?? null}
        .shownBounds=${isOfOthers ? shown.bounds : null}
        .unusedLockedBoxes=${reduced?.result.report.unusedLockedBoxes ?? []}
        .reduction=${result}
        .measured=${this.#isMeasured}
        .verification=${this.#verifying.state}
        ?busy=${progress !== null}
        .curve=${this.#curve.points}
        .canUndo=${canUndo}
        .canRedo=${canRedo}
        @verify=${() => this.#verifying.start()}
        @verify-cancel=${() => this.#verifying.cancel()}
        @undo=${() => session.undo()}
        @redo=${() => session.redo()}
        @bounds-change=${({ detail }: CustomEvent<BoundChange>) => this.#changeBounds(detail)}
        @worst-wanted=${({ detail }: CustomEvent<string>) => this.#showWorst(detail)}
        @chart-toggle=${({ detail }: CustomEvent<boolean>) => this.#showChart(detail)}
        @method-change=${({ detail }: CustomEvent<Method>) => this.#set(detail)}
        @keeping-change=${({ detail }: CustomEvent<Partial<Keeping>>) => this.#set(keepingText({ ...keeping, ...detail }))}
      ></meshbound-bounds-panel>
    </div>`;
  }

  #levelsPanel() {
    const { levels, session } = this.viewer;
    return html`<meshbound-levels-panel
      role="region"
      aria-label=${english.levels.region}
      .levels=${levels.state}
      ?disabled=${!session.state.surface}
      @level-count=${({ detail }: CustomEvent<number>) => levels.setCount(detail)}
      @level-pixels=${({ detail }: CustomEvent<number | null>) => levels.setPixels(detail)}
      @level-position=${({ detail }: CustomEvent<number>) => levels.setPosition(detail)}
    ></meshbound-levels-panel>`;
  }

  #resultBar() {
    const { session, shown } = this.viewer;
    const { opening, progress, cancelled, refusal } = session.state;
    const result = this.#result;
    return html`<meshbound-result-bar
      role="contentinfo"
      .report=${shown?.result.report ?? null}
      .measured=${this.#isMeasured}
      .lead=${this.viewer.resultLead}
      .refusal=${refusal}
      ?multiplied=${result?.multiplier !== undefined}
      .opening=${opening}
      .progress=${progress}
      .cancelled=${cancelled}
      @cancel=${() => session.cancel()}
      @reduce-again=${() => session.reduceAgain()}
    >
      ${this.#saveMenu(result !== null)}
    </meshbound-result-bar>`;
  }

  #saveMenu(hasResult: boolean) {
    const hasLevels = this.viewer.levels.state.nested !== null;
    const items: MenuItem[] = [
      ...savedKinds
        .filter((kind) => kind !== 'levels' || hasLevels)
        .map((kind) => ({ ...pageEnglish.page.saved[kind], take: () => this.#save(kind) })),
      { ...pageEnglish.page.picture, take: () => this.#savePicture(true) },
      { ...pageEnglish.page.barePicture, take: () => this.#savePicture(false) },
    ];
    const { standing } = this.viewer;
    const isEarlier = standing === 'refused' || standing === 'cancelled';
    const label = isEarlier ? pageEnglish.page.saveEarlier : pageEnglish.page.save;
    return html`<meshbound-menu label=${label} ?disabled=${!hasResult} .items=${items}></meshbound-menu>`;
  }

  async #save(kind: SavedKind): Promise<void> {
    try {
      await this.viewer.save(kind);
    } catch {
      // The answer that was waited for does not come: the page says that it was cancelled, or why it failed.
    }
  }

  async #savePicture(legends: boolean): Promise<void> {
    try {
      const { surface } = this.viewer.session.state;
      download(savedFileName(surface?.name ?? '', 'picture', 'png'), await this.viewer.toBlob({ legends }));
    } catch (error) {
      this.viewer.session.report(error, { about: 'saved' });
    }
  }

  #shareMenu() {
    const link = this.#link.address === null ? pageEnglish.page.noLink : pageEnglish.page.copyLink;
    const items: MenuItem[] = [
      { ...link, disabled: this.#link.address === null, take: this.#copyLink },
      { ...pageEnglish.page.copyEmbed, take: () => this.#copy(this.#link.snippet) },
      { ...pageEnglish.page.saveState, take: this.#saveState },
      { ...pageEnglish.page.loadState, take: this.#browseState },
    ];
    return html`<meshbound-menu label=${pageEnglish.page.share} .items=${items}></meshbound-menu>`;
  }

  #openSample({ address }: Sample): void {
    this.#forget();
    this.viewer.src = address;
  }

  /** What was of the surface before, and would mean nothing to another one. */
  #forget(): void {
    this.viewer.session.wantBounds(null, { later: true });
    Object.assign(this.viewer, { camera: null, ...keepingText(nothingKept) });
  }

  #openFiles(files: File[]): void {
    const file = surfaceAmong(files);
    if (!file) return;
    if (/\.json$/i.test(file.name)) {
      void this.#openState(file);
      return;
    }
    this.#forget();
    void this.viewer.open(file, ...files.filter((other) => other !== file));
  }

  /** Attributes of the viewer that the controls change. */
  #set(wanted: Partial<WantedView & Method & WantedKeeping>): void {
    Object.assign(this.viewer, wanted);
    this.#changed();
  }

  #showChart(shown: boolean): void {
    this.#charted = shown;
    this.#followCurve();
  }

  #followVerifying(): void {
    const { surface, progress } = this.viewer.session.state;
    this.#verifying.follow(surface?.mesh ?? null, this.#result, progress !== null);
  }

  #followCurve(): void {
    this.#curve.follow(this.#charted ? this.viewer.session.state : null);
  }

  #changed(): void {
    this.#followVerifying();
    this.requestUpdate();
    this.#link.update();
  }

  #copyLink = (): Promise<string | undefined> => {
    const { address } = this.#link;
    return address ? this.#copy(address) : Promise.resolve(undefined);
  };

  async #copy(text: string): Promise<string | undefined> {
    try {
      await navigator.clipboard.writeText(text);
      return pageEnglish.page.copied;
    } catch {
      this.viewer.session.report(english.faults.cannotCopy(text), { about: 'copied' });
      return undefined;
    }
  }

  #saveState = (): void => download('meshbound-state.json', stateJson(this.viewer.state));

  #browseState = (): void => {
    const input = document.createElement('input');
    input.type = 'file';
    input.accept = '.json';
    input.addEventListener('change', () => input.files?.[0] && this.#openState(input.files[0]));
    input.click();
  };

  async #openState(file: File): Promise<void> {
    try {
      this.viewer.state = stateFromJson(await file.text());
      this.viewer.session.forget('state');
      this.#changed();
    } catch (error) {
      this.viewer.session.report(`${file.name}: ${messageOf(error)}`, { about: 'state' });
    }
  }

  #pressKey = (event: KeyboardEvent): void => {
    const target = event.composedPath()[0];
    const typing = target instanceof HTMLInputElement && target.type === 'text';
    if (typing || target instanceof HTMLSelectElement || event.altKey) return;
    if (event.key === 'Escape') this.viewer.unpin();
    const command = event.ctrlKey || event.metaKey;
    const key = `${command ? 'Ctrl ' : ''}${event.shiftKey ? 'Shift ' : ''}${event.key.toLowerCase()}`;
    if (!(key in this.#keys)) return;
    event.preventDefault();
    this.#keys[key]();
  };

  /** What keys do anywhere on the page; those of a surface are its own. */
  #keys: Record<string, () => void> = {
    'Ctrl z': () => this.viewer.session.undo(),
    'Ctrl y': () => this.viewer.session.redo(),
    'Ctrl Shift z': () => this.viewer.session.redo(),
    h: () => this.#toggleKeys(),
    o: () => this.renderRoot.querySelector<Toolbar>('meshbound-toolbar')?.browse(),
    e: () => this.#set({ edges: !this.viewer.edges }),
    f: () => this.viewer.fit(),
  };

  /** Where the window is narrow, the surfaces are above the bounds, out of sight. */
  #showWorst(variable: string): void {
    void this.viewer.probeWorst(variable);
    this.viewer.scrollIntoView({ block: 'nearest' });
  }

  #toggleKeys(): void {
    this.renderRoot.querySelector<KeySheet>('meshbound-key-sheet')?.toggle();
  }

  #changeBounds(change: BoundChange): void {
    const { session } = this.viewer;
    if ('all' in change) session.setAllBounds(change.all);
    else if ('bounds' in change) session.setBounds(change.bounds);
    else session.setBound(change.variable, change.setting);
  }
}

customElements.define('meshbound-app', App);
