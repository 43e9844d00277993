import { css, html, LitElement } from 'lit';
import type { Report } from '../../../wasm/types.ts';
import { controlsStyle } from '../../element/controls/controls-style.ts';
import { type HeldBack as Held, heldBackShares, roughShareText } from '../../element/result/guarantee-words.ts';
import { english } from '../../words/english.ts';

/** What holds a reduction back: which bound to loosen for fewer triangles. */
export class HeldBack extends LitElement {
  static override properties = { report: { attribute: false } };

  static override styles = [
    controlsStyle,
    css`
      :host {
        display: block;
        /* Room for the words before they come. */
        min-height: calc(1.4em + 12px + 3 * 1.4 * var(--text-small));
        margin-bottom: 8px;
      }
      .next {
        /* So many lines that a few reasons more or less do not move the bounds below. */
        min-height: calc(3 * 1.4 * var(--text-small));
      }
      p {
        overflow-wrap: anywhere;
      }
      .bar {
        display: flex;
        gap: 1px;
        height: 6px;
        margin: 3px 0;
        overflow: hidden;
        border-radius: 3px;
      }
      .bar span {
        min-width: 1px;
        background: var(--accent-soft);
      }
      .bar span:first-child {
        background: var(--accent);
      }
    `,
  ];

  declare report: Report | null;

  constructor() {
    super();
    this.report = null;
  }

  override render() {
    if (!this.report) return html``;
    const [most, ...rest] = heldBackShares(this.report);
    if (!most) return html`<p class="soft">${english.heldBack.nothing}</p>`;
    return html`
      <p title=${english.heldBack.what}>
        ${english.heldBack.most} <b>${most.reason}</b>: ${roughShareText(most.share)}
      </p>
      <div class="bar" aria-hidden="true">
        ${[most, ...rest].map(
          ({ reason, share }) =>
            html`<span title="${reason} ${roughShareText(share)}" .style=${`flex:${share}`}></span>`,
        )}
      </div>
      <p class="next small soft">${english.heldBack.next(rest.map(words))}</p>
    `;
  }
}

function words({ reason, share }: Held): string {
  return `${reason} ${roughShareText(share)}`;
}

customElements.define('meshbound-held-back', HeldBack);
