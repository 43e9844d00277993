import { css, html, LitElement } from 'lit';
import { controlsStyle } from '../element/controls-style.ts';

const keys: [string, string][] = [
  ['h', 'this list'],
  ['o', 'open a file'],
  ['e', 'edges'],
  ['f', 'fit into view'],
  ['Ctrl Z, Ctrl Y', 'undo and redo the change of a bound'],
  ['Tab, Shift Tab', 'go through all controls, and to the surfaces'],
  ['← → ↑ ↓', 'on a surface: turn it; on a slider or the divider: move it'],
  ['Shift ← → ↑ ↓', 'on a surface: move it'],
  ['+ and −', 'on a surface: nearer, farther'],
  ['0', 'on a surface: fit into view'],
  ['Enter', 'on a surface: pin what its middle shows; a click pins any place'],
  ['Esc', 'let go of it'],
];

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
      <h2 id="title">Keys</h2>
      <dl>${keys.map(([key, meaning]) => html`<dt>${key}</dt><dd>${meaning}</dd>`)}</dl>
      <button @click=${() => this.#dialog.close()}>Close</button>
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
