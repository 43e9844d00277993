import { css, html, LitElement, nothing } from 'lit';
import type { Report } from '../../../wasm/types.ts';
import type { Opening } from '../../session/session-state.ts';
import { english } from '../../words/english.ts';
import { controlsStyle } from '../controls/controls-style.ts';
import { removedText, secondsText } from '../number-text.ts';
import { guaranteeSentence, isProvisional } from './guarantee-words.ts';
import { openingText } from './progress.ts';

/**
 * The result as one sentence, what it cost, and, in its slot, where to take it.
 *
 * @csspart sentence
 * @csspart numbers
 *
 * @fires cancel
 * @fires reduce-again
 */
export class ResultBar extends LitElement {
  static override properties = {
    report: { attribute: false },
    measured: { type: Boolean },
    multiplied: { type: Boolean },
    lead: {},
    refusal: { attribute: false },
    opening: { attribute: false },
    progress: { attribute: false },
    cancelled: { type: Boolean },
    cut: { state: true },
    whole: { state: true },
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
        min-height: calc(2 * 1.4em + 17px);
        padding: 8px 16px;
      }
      .said {
        position: relative;
        flex: 1 1 320px;
      }
      .sentence {
        display: -webkit-box;
        -webkit-box-orient: vertical;
        -webkit-line-clamp: var(--sentence-lines, none);
        overflow: hidden;
        overflow-wrap: anywhere;
      }
      .whole .sentence {
        display: block;
        max-height: 50dvh;
        overflow-y: auto;
      }
      /* At the end of the last line that is to be seen, over what would go on there. */
      .more {
        position: absolute;
        right: 0;
        bottom: calc(0.7em - 12px);
        min-height: 24px;
        padding: 0 0 0 2em;
        text-decoration: underline;
        background: linear-gradient(to right, transparent, var(--panel) 1.5em) center / 100% 1.4em no-repeat;
        border: none;
      }
      .whole .more {
        position: static;
        padding: 0;
      }
      /* Of earlier bounds, or provisional, while a reduction runs; most are over before anyone could see that. */
      .sentence.passing {
        color: var(--ink-soft);
        transition: color 0s 0.15s;
      }
      .numbers {
        display: flex;
        gap: var(--gap);
        align-items: center;
        white-space: nowrap;
      }
      /* Most reductions end before anyone could want to cancel them: no button flashes up. */
      .cancel {
        visibility: hidden;
        animation: appear 0s 0.4s forwards;
      }
      @keyframes appear {
        to {
          visibility: visible;
        }
      }
    `,
  ];

  /** Of the last result; null where there is none. */
  declare report: Report | null;
  /** Whether the errors of the report were measured; otherwise they are limits from above. */
  declare measured: boolean;
  /** Whether the bounds were multiplied by what differs over the surface. */
  declare multiplied: boolean;
  /** What has to be said before the sentence: that the result is not the answer to what is asked for. */
  declare lead: string;
  /** Why what is asked for is not reduced; null where nothing is wrong. */
  declare refusal: string | null;
  declare opening: Opening | null;
  /** Of the running reduction, 0…1; null where none runs. */
  declare progress: number | null;
  /** The last reduction was cancelled. */
  declare cancelled: boolean;
  /** The sentence has more lines than it may (--sentence-lines). @internal */
  declare cut: boolean;
  /** It is to be seen whole nevertheless. @internal */
  declare whole: boolean;

  #resizes = new ResizeObserver(() => this.#measureSentence());

  constructor() {
    super();
    this.report = null;
    this.measured = true;
    this.multiplied = false;
    this.lead = '';
    this.refusal = null;
    this.opening = null;
    this.progress = null;
    this.cancelled = false;
    this.cut = false;
    this.whole = false;
  }

  override render() {
    return html`
      <div class="said ${this.whole ? 'whole' : ''}">
        <p part="sentence" class="sentence ${this.progress === null ? '' : 'passing'}">
          ${this.report ? this.#sentence(this.report) : this.#notReduced()}
        </p>
        <span class="unseen" role="status">${this.#spoken()}</span>
        ${this.cut || this.whole ? this.#moreButton() : nothing}
      </div>
      <span part="numbers" class="numbers soft">${this.#numbers()}</span>
      <slot></slot>
    `;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.#resizes.observe(this);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#resizes.disconnect();
  }

  override updated(): void {
    this.#measureSentence();
  }

  /** One that is longer than its room is cut, or scrolls where it is whole, and must be reached from the keyboard then. */
  #measureSentence(): void {
    const sentence = this.renderRoot.querySelector<HTMLElement>('.sentence');
    if (!sentence) return;
    const isLonger = sentence.scrollHeight > sentence.clientHeight;
    this.cut = isLonger && !this.whole;
    if (isLonger && this.whole) sentence.tabIndex = 0;
    else sentence.removeAttribute('tabindex');
  }

  #sentence(report: Report): string {
    const sentence = guaranteeSentence(report, this.measured, this.multiplied);
    const provisional = isProvisional(report) ? english.sentence.provisional : '';
    return [this.lead, provisional, sentence].filter(Boolean).join(' ');
  }

  #notReduced(): string {
    return this.refusal === null ? '' : english.sentence.notReduced(this.refusal);
  }

  /** Not while a reduction runs: what is on the way to the answer would be read out again and again. */
  #spoken(): string {
    return this.report && this.progress === null && !isProvisional(this.report) ? this.#sentence(this.report) : '';
  }

  #moreButton() {
    const { all, less } = english.sentence;
    return html`<button class="more" aria-expanded=${this.whole} @click=${() => {
      this.whole = !this.whole;
    }}>${this.whole ? less : all}</button>`;
  }

  #numbers() {
    if (this.opening) return html`<span>${openingText(this.opening)}</span>${this.#cancelButton()}`;
    if (this.progress !== null) {
      const { exact, reducing } = english.progress;
      const say = this.report && isProvisional(this.report) ? exact : reducing;
      return html`<span>${say(Math.round(100 * this.progress))}</span>
        ${this.#cancelButton()}`;
    }
    if (this.cancelled) {
      const kept = this.report ? english.progress.keptBefore : '';
      return html`<span title=${kept}>${english.progress.cancelled}</span>
        <button @click=${() => this.#fire('reduce-again')}>${english.progress.reduce}</button>`;
    }
    if (!this.report) return nothing;
    const { triangles, seconds } = this.report;
    const removed = removedText(triangles.before, triangles.after);
    return html`<span>${english.progress.removed(removed, secondsText(seconds))}</span>`;
  }

  #cancelButton() {
    return html`<button class="cancel" @click=${() => this.#fire('cancel')}>${english.progress.cancel}</button>`;
  }

  #fire(event: string): void {
    this.dispatchEvent(new CustomEvent(event));
  }
}

customElements.define('meshbound-result-bar', ResultBar);
