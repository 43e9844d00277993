import { css, html, LitElement, nothing } from 'lit';
import { repeat } from 'lit/directives/repeat.js';
import type { Notice } from '../../session/session-state.ts';
import { english } from '../../words/english.ts';
import { controlsStyle } from './controls-style.ts';

const { ours } = english.notices;

/** An error of ours is told in words that say what still works; what the program calls it is folded away. */
function textOf({ kind, code, text }: Notice) {
  if (kind !== 'error' || !code || !Object.hasOwn(ours, code)) return html`<p>${text}</p>`;
  return html`<div class="text">
    <p>${ours[code as keyof typeof ours]}</p>
    <details><summary>${english.notices.detail}</summary>${text}</details>
  </div>`;
}

/** Milliseconds after which what is passing goes by itself. */
const passingTime = 10_000;

/**
 * What went wrong or is worth knowing, until dismissed.
 *
 * @fires dismiss with the notice's id
 */
export class Notices extends LitElement {
  static override properties = { notices: { attribute: false } };

  static override styles = [
    controlsStyle,
    css`
      .notice {
        display: flex;
        flex-wrap: wrap;
        gap: var(--gap);
        align-items: center;
        justify-content: end;
        margin-bottom: var(--gap);
        padding: 8px 8px 8px 12px;
        background: var(--panel);
        border: 1px solid var(--control-line);
        border-radius: var(--radius);
        box-shadow: 0 2px 8px rgb(0 0 0 / 15%);
      }
      .notice.error {
        background: var(--fault-soft);
        border-color: var(--fault);
      }
      p,
      .text {
        flex: 1 1 200px;
        overflow-wrap: anywhere;
      }
      details {
        margin-top: 4px;
        font-size: var(--text-small);
      }
      summary {
        cursor: pointer;
      }
    `,
  ];

  declare notices: readonly Notice[];
  /** Those that will go by themselves. */
  #passing = new Set<number>();

  constructor() {
    super();
    this.notices = [];
  }

  override render() {
    return repeat(
      this.notices,
      ({ id }) => id,
      (
        notice,
      ) => html`<div part="notice" class="notice ${notice.kind}" role=${notice.kind === 'error' ? 'alert' : 'status'}>
        ${textOf(notice)}
        ${notice.remedy ? html`<button @click=${notice.remedy.take}>${notice.remedy.label}</button>` : nothing}
        <button @click=${() => this.#dismiss(notice.id)}>${english.notices.dismiss}</button>
      </div>`,
    );
  }

  override updated(changed: Map<string, unknown>): void {
    if (!changed.has('notices')) return;
    for (const { id, passing } of this.notices) {
      if (!passing || this.#passing.has(id)) continue;
      this.#passing.add(id);
      setTimeout(() => this.#dismiss(id), passingTime);
    }
  }

  #dismiss(id: number): void {
    this.dispatchEvent(new CustomEvent('dismiss', { detail: id }));
  }
}

customElements.define('meshbound-notices', Notices);
