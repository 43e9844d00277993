import { css, html, LitElement, nothing } from 'lit';
import type { Report } from '../../wasm/types.ts';
import { controlsStyle } from './controls-style.ts';
import { percentText, secondsText } from './number-text.ts';
import { promiseSentence } from './promise-words.ts';

/** The formats that a reduced surface is saved in. */
export const savedFormats = ['ply', 'vtp'] as const;
export type SavedFormat = (typeof savedFormats)[number];

/**
 * The result as one sentence, what it cost, and where to take it.
 *
 * @fires save with a SavedFormat
 */
export class ResultBar extends LitElement {
  static override properties = {
    report: { attribute: false },
    opening: {},
    progress: { attribute: false },
  };

  static override styles = [
    controlsStyle,
    css`
      :host {
        position: relative;
        display: flex;
        flex-wrap: wrap;
        gap: var(--gap) 24px;
        align-items: center;
        /* Room for two lines, so that the stage keeps its height. */
        min-height: 56px;
        padding: 8px 16px;
      }
      .sentence {
        flex: 1 1 320px;
        overflow-wrap: anywhere;
      }
      .numbers,
      .saves {
        display: flex;
        gap: var(--gap);
        align-items: center;
        white-space: nowrap;
      }
      .progress {
        position: absolute;
        top: -1px;
        left: 0;
        height: 2px;
        background: var(--accent);
      }
    `,
  ];

  /** Of the last result; null where there is none. */
  declare report: Report | null;
  /** The file that is being read. */
  declare opening: string | null;
  /** Of the running reduction, 0…1; null where none runs. */
  declare progress: number | null;

  constructor() {
    super();
    this.report = null;
    this.opening = null;
    this.progress = null;
  }

  override render() {
    return html`
      ${
        this.progress === null
          ? nothing
          : html`<div class="progress" aria-hidden="true" style="width:${100 * this.progress}%"></div>`
      }
      <p class="sentence" role="status">${this.report ? promiseSentence(this.report) : ''}</p>
      <span class="numbers soft">${this.#numbers()}</span>
      <span class="saves">
        ${savedFormats.map(
          (format) => html`<button ?disabled=${!this.report} @click=${() => this.#save(format)}>
            Save ${format.toUpperCase()}
          </button>`,
        )}
      </span>
    `;
  }

  #numbers() {
    if (this.opening !== null) return html`<span>Reading ${this.opening}…</span>`;
    if (this.progress !== null) return html`<span>Reducing… ${Math.round(100 * this.progress)}&nbsp;%</span>`;
    if (!this.report) return nothing;
    const { triangles, seconds } = this.report;
    const removed = 1 - triangles.after / triangles.before;
    return html`<span>${percentText(removed)} removed in ${secondsText(seconds)}</span>`;
  }

  #save(format: SavedFormat): void {
    this.dispatchEvent(new CustomEvent('save', { detail: format }));
  }
}

customElements.define('meshbound-result-bar', ResultBar);
