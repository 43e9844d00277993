import { css, html, LitElement } from 'lit';
import { controlsStyle } from '../../element/controls/controls-style.ts';
import { pageEnglish } from '../../words/page-english.ts';

/** The keys, in a dialogue. */
export class KeySheet extends LitElement {
  static override styles = [
    controlsStyle,
    css`
      dialog {
        max-width: min(480px, 100vw - 24px);
        color: var(--ink);
        background: var(--panel);
        border: 1px solid var(--control-line);
        border-radius: var(--radius);
      }
      dl {
        display: grid;
        grid-template-columns: auto 1fr;
        gap: 6px 16px;
        margin: 12px 0;
      }
      dt {
        font-weight: 600;
      }
      dd {
        margin: 0;
      }
    `,
  ];

  override render() {
    return html`<dialog aria-labelledby="title">
      <h2 id="title">${pageEnglish.keys.title}</h2>
      <dl>${pageEnglish.keys.list.map(([key, meaning]) => html`<dt>${key}</dt><dd>${meaning}</dd>`)}</dl>
      <button @click=${() => this.#dialog.close()}>${pageEnglish.keys.close}</button>
    </dialog>`;
  }

  toggle(): void {
    if (this.#dialog.open) this.#dialog.close();
    else this.#dialog.showModal();
  }

  get #dialog(): HTMLDialogElement {
    return this.renderRoot.querySelector('dialog') as HTMLDialogElement;
  }
}

customElements.define('meshbound-key-sheet', KeySheet);
