import { css, html, LitElement } from 'lit';
import { live } from 'lit/directives/live.js';
import { controlsStyle } from '../../element/controls/controls-style.ts';
import '../../element/controls/view-controls.ts';
import { firstView, type ViewSettings, type WantedView } from '../../element/attributes/view-settings.ts';
import { formatNames } from '../../formats/format-names.ts';
import type { BoundSettings } from '../../session/bounds/bound-setting.ts';
import type { OpenSurface } from '../../session/reading/open-surface.ts';
import type { Opening } from '../../session/session-state.ts';
import { pageEnglish } from '../../words/page-english.ts';
import type { Sample } from './samples.ts';

/** What the file dialogue offers: a glTF may also be text, and all may be packed. The content of a file decides what it is. */
const offeredEndings = [...Object.keys(formatNames), 'gltf', 'bin', 'csv', 'gz'].map((ending) => `.${ending}`).join();

/**
 * File, sample, and the controls of the view.
 *
 * @fires open-files with a list of File, chosen together
 * @fires open-sample with a Sample
 * @fires view-change with what is wanted now: a Partial<WantedView>
 * @fires fit
 * @fires look-from with a ViewDirection
 */
export class Toolbar extends LitElement {
  static override properties = {
    samples: { attribute: false },
    opening: { attribute: false },
    surface: { attribute: false },
    bounds: { attribute: false },
    settings: { attribute: false },
  };

  static override styles = [
    controlsStyle,
    css`
      :host {
        display: flex;
        flex-wrap: wrap;
        gap: var(--gap) 16px;
        align-items: center;
        padding: 8px 16px;
        container: bar / inline-size;
      }
      h1 {
        font-weight: 650;
      }
      .group {
        display: flex;
        flex-wrap: wrap;
        gap: var(--gap);
        align-items: center;
      }
      label {
        display: inline-flex;
        gap: 6px;
        align-items: center;
        white-space: nowrap;
      }
      select {
        width: 122px;
        text-overflow: ellipsis;
      }
      @media (max-width: 800px) {
        :host {
          gap: var(--gap) 10px;
        }
        .group {
          display: contents;
        }
        select {
          width: 108px;
        }
      }
    `,
  ];

  declare samples: readonly Sample[];
  /** What is being opened. The choice of a sample is drawn again when it ends, however it ends. */
  declare opening: Opening | null;
  declare surface: OpenSurface | null;
  declare bounds: BoundSettings;
  declare settings: ViewSettings;

  constructor() {
    super();
    this.samples = [];
    this.opening = null;
    this.surface = null;
    this.bounds = {};
    this.settings = firstView;
  }

  override render() {
    return html`
      <h1>${pageEnglish.page.title}</h1>
      <div class="group">${this.#fileControls()}</div>
      <meshbound-view-controls
        .surface=${this.surface}
        .bounds=${this.bounds}
        .settings=${this.settings}
        @view-change=${({ detail }: CustomEvent<Partial<WantedView>>) =>
          this.dispatchEvent(new CustomEvent('view-change', { detail }))}
        @fit=${() => this.dispatchEvent(new CustomEvent('fit'))}
        @look-from=${({ detail }: CustomEvent<string>) => this.dispatchEvent(new CustomEvent('look-from', { detail }))}
      ></meshbound-view-controls>
    `;
  }

  #fileControls() {
    const open = this.surface?.address;
    return html`
      <button @click=${this.browse}>${pageEnglish.page.open}</button>
      <input type="file" hidden multiple accept=${offeredEndings} @change=${this.#openFiles} />
      <label>
        <span class="soft">${pageEnglish.page.sample}</span>
        <select @change=${this.#openSample}>
          <option value="" disabled .selected=${live(!this.samples.some(({ address }) => address === open))}>${pageEnglish.page.chooseSample}</option>
          ${this.samples.map(
            ({ name, title, address }) =>
              html`<option value=${name} .selected=${live(address === open)}>${title}</option>`,
          )}
        </select>
      </label>
      <slot></slot>
    `;
  }

  /** Asks for a file to open, with those that belong to it. */
  browse(): void {
    this.renderRoot.querySelector<HTMLInputElement>('input[type=file]')?.click();
  }

  #openFiles({ target }: Event): void {
    const input = target as HTMLInputElement;
    const files = Array.from(input.files ?? []);
    // Emptied, so that choosing the same file again is a change.
    input.value = '';
    if (files.length > 0) this.dispatchEvent(new CustomEvent('open-files', { detail: files }));
  }

  #openSample(event: Event): void {
    const sample = this.samples.find(({ name }) => name === chosen(event));
    if (sample) this.dispatchEvent(new CustomEvent('open-sample', { detail: sample }));
  }
}

function chosen({ target }: Event): string {
  return (target as HTMLSelectElement).value;
}

customElements.define('meshbound-toolbar', Toolbar);
