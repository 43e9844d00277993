import { css, html, LitElement } from 'lit';
import { controlsStyle } from '../../element/controls/controls-style.ts';

/** One thing that a menu offers. */
export interface MenuItem {
  text: string;
  /** What it is, for those who do not know it yet. */
  title?: string;
  /** Does it; may resolve to what the user is told of its success. */
  take: () => unknown;
  /** It cannot be done now; the title says why. */
  disabled?: boolean;
}

/** How long success is told, in milliseconds. */
const toldFor = 2500;
/** Room between the button and its list, in pixels. */
const distance = 4;

/** A button that opens a list of things to do. */
export class Menu extends LitElement {
  static override properties = {
    label: {},
    items: { attribute: false },
    disabled: { type: Boolean },
    told: { state: true },
  };

  static override styles = [
    controlsStyle,
    css`
      :host {
        display: inline-block;
      }
      [popover] {
        inset: auto;
        width: max-content;
        min-width: 150px;
        margin: 0;
        padding: 4px;
        color: var(--ink);
        background: var(--panel);
        border: 1px solid var(--control-line);
        border-radius: var(--radius);
        box-shadow: 0 2px 8px rgb(0 0 0 / 15%);
      }
      [popover] button {
        display: block;
        width: 100%;
        border-color: transparent;
        text-align: left;
      }
    `,
  ];

  declare label: string;
  declare items: readonly MenuItem[];
  declare disabled: boolean;
  /** What is told of what was just done. */
  declare told: string;

  constructor() {
    super();
    this.label = '';
    this.items = [];
    this.disabled = false;
    this.told = '';
  }

  override render() {
    return html`
      <button id="opener" popovertarget="list" ?disabled=${this.disabled} @click=${this.#place}>
        ${this.told || this.label}
      </button>
      <span class="unseen" role="status">${this.told}</span>
      <div id="list" popover @toggle=${this.#place}>
        ${this.items.map(
          (item) =>
            html`<button title=${item.title ?? ''} ?disabled=${item.disabled} @click=${() => this.#take(item)}>${item.text}</button>`,
        )}
      </div>
    `;
  }

  async #take({ take }: MenuItem): Promise<void> {
    this.#list.hidePopover();
    const said = await take();
    if (typeof said !== 'string') return;
    this.told = said;
    setTimeout(() => (this.told = ''), toldFor);
  }

  get #list(): HTMLElement {
    return this.renderRoot.querySelector('#list') as HTMLElement;
  }

  /** Below the button, or above where there is no room; inside the window. */
  #place(): void {
    const opener = (this.renderRoot.querySelector('#opener') as HTMLElement).getBoundingClientRect();
    const list = this.#list.getBoundingClientRect();
    const below = opener.bottom + distance;
    const top = below + list.height <= innerHeight ? below : opener.top - distance - list.height;
    const left = Math.min(opener.left, innerWidth - list.width - distance);
    this.#list.style.top = `${Math.max(0, top)}px`;
    this.#list.style.left = `${Math.max(0, left)}px`;
  }
}

customElements.define('meshbound-menu', Menu);
