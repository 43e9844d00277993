import { css, html, LitElement, nothing } from 'lit';
import { repeat } from 'lit/directives/repeat.js';
import type { Notice } from '../session/session-state.ts';
import { english } from '../words/english.ts';
import { controlsStyle } from './controls-style.ts';

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
      p {
        flex: 1 1 200px;
        overflow-wrap: anywhere;
      }
    `,
  ];

  declare notices: readonly Notice[];

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
        <p>${notice.text}</p>
        ${notice.remedy ? html`<button @click=${notice.remedy.take}>${notice.remedy.label}</button>` : nothing}
        <button @click=${() => this.#dismiss(notice.id)}>${english.notices.dismiss}</button>
      </div>`,
    );
  }

  #dismiss(id: number): void {
    this.dispatchEvent(new CustomEvent('dismiss', { detail: id }));
  }
}

customElements.define('meshbound-notices', Notices);
