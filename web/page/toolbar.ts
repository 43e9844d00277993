import { css, html, LitElement } from 'lit';
import { live } from 'lit/directives/live.js';
import { valueColormaps } from '../colour/colormaps.ts';
import { componentsOf } from '../colour/field.ts';
import { controlsStyle } from '../element/controls-style.ts';
import { firstView, hasSign, type Quantity, type ViewSettings, type WantedView } from '../element/view-settings.ts';
import { formatNames } from '../formats/format-names.ts';
import type { BoundSettings } from '../session/bound-setting.ts';
import type { OpenSurface } from '../session/session.ts';
import type { Sample } from './samples.ts';

/** What the file dialogue offers: a glTF may also be text, and all may be packed. The content of a file decides what it is. */
const offeredEndings = [...Object.keys(formatNames), 'gltf', 'gz'].map((ending) => `.${ending}`).join();

const quantityNames: Record<Quantity, string> = {
  value: 'values',
  error: 'error / bound',
  'signed-error': 'signed error',
};

/** The maps that errors always have. */
const errorMaps: Record<Exclude<Quantity, 'value'>, string> = { error: 'YlOrBr', 'signed-error': 'diverging' };

/** A variable, or a component of one, to be looked at. */
interface Choice {
  view: Partial<WantedView>;
  selected: boolean;
  disabled: boolean;
  text: string;
}

/**
 * File, sample, colours and view.
 *
 * @fires open-file with a File
 * @fires open-sample with a Sample
 * @fires view-change with what is wanted now: a Partial<WantedView>
 * @fires fit
 */
export class Toolbar extends LitElement {
  static override properties = {
    samples: { attribute: false },
    opening: {},
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
      .view {
        margin-left: auto;
      }
      label {
        display: inline-flex;
        gap: 6px;
        align-items: center;
        white-space: nowrap;
      }
      /* Fixed, so that the bar does not change its shape when variables come. */
      select {
        width: 150px;
        text-overflow: ellipsis;
      }
      select.middle {
        width: 138px;
      }
      select.narrow {
        width: 104px;
      }
      @media (max-width: 800px) {
        .view {
          margin-left: 0;
        }
        :host {
          gap: var(--gap) 10px;
        }
        .group {
          display: contents;
        }
        select {
          width: 108px;
        }
        select.middle {
          width: 134px;
        }
        select.narrow {
          width: 96px;
        }
      }
    `,
  ];

  declare samples: readonly Sample[];
  /** What is being opened. The choice of a sample is drawn again when it ends, however it ends. */
  declare opening: string | null;
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
      <h1>Meshbound</h1>
      <div class="group">${this.#fileControls()}</div>
      <div class="group">${this.#colourControls()}</div>
      <div class="group view">${this.#viewControls()}</div>
    `;
  }

  #fileControls() {
    const open = this.surface?.address;
    return html`
      <button @click=${this.#browse}>Open…</button>
      <input type="file" hidden accept=${offeredEndings} @change=${this.#openFile} />
      <label>
        <span class="soft">Sample</span>
        <select @change=${this.#openSample}>
          <option value="" disabled .selected=${live(!this.samples.some(({ address }) => address === open))}>choose…</option>
          ${this.samples.map(
            ({ name, title, address }) =>
              html`<option value=${name} .selected=${live(address === open)}>${title}</option>`,
          )}
        </select>
      </label>
    `;
  }

  #colourControls() {
    const { quantity } = this.settings;
    return html`
      <label><span class="soft">Colour</span>${this.#variableChoice()}</label>
      <label><span class="soft">Show</span>${this.#quantityChoice()}</label>
      <label title=${quantity === 'value' ? '' : 'Errors have colour maps of their own.'}>
        <span class="soft">Map</span>
        ${quantity === 'value' ? this.#mapChoice() : this.#givenMap(errorMaps[quantity])}
      </label>
    `;
  }

  #mapChoice() {
    const { colormap } = this.settings;
    return html`<select
      class="narrow"
      @change=${(event: Event) => this.#change({ colormap: chosen(event) })}
    >
      ${valueColormaps.map((name) => html`<option .selected=${live(name === colormap)}>${name}</option>`)}
    </select>`;
  }

  #givenMap(name: string) {
    return html`<select class="narrow" disabled><option>${name}</option></select>`;
  }

  #quantityChoice() {
    const variable = this.surface?.variables.find(({ name }) => name === this.settings.variable);
    return html`<select
      class="middle"
      @change=${(event: Event) => this.#change({ show: chosen(event) })}
    >
      ${Object.entries(quantityNames).map(
        ([name, text]) =>
          html`<option
            value=${name}
            .selected=${live(name === this.settings.quantity)}
            ?disabled=${name === 'signed-error' && variable && !hasSign(variable)}
          >
            ${text}
          </option>`,
      )}
    </select>`;
  }

  /** Values are chosen by component; an error is that of a whole variable. */
  #variableChoice() {
    const choices = this.settings.quantity === 'value' ? this.#valueChoices() : this.#errorChoices();
    return html`<select @change=${(event: Event) => this.#change(choices[Number(chosen(event))].view)}>
      ${choices.map(
        ({ selected, disabled, text }, index) =>
          html`<option value=${index} .selected=${live(selected)} ?disabled=${disabled}>${text}</option>`,
      )}
    </select>`;
  }

  #valueChoices(): Choice[] {
    const names = this.surface?.labels.componentNames ?? {};
    return (this.surface?.variables ?? []).flatMap((variable) =>
      componentsOf(variable.components, names[variable.name]).map(({ component, label }) => ({
        view: { variable: variable.name, component: label },
        selected: variable.name === this.settings.variable && component === this.settings.component,
        disabled: false,
        text: variable.components === 1 ? variable.name : `${variable.name}, ${label}`,
      })),
    );
  }

  #errorChoices(): Choice[] {
    return (this.surface?.variables ?? []).map((variable) => ({
      view: { variable: variable.name },
      selected: variable.name === this.settings.variable,
      disabled: this.settings.quantity === 'error' && this.bounds[variable.name]?.free === true,
      text: variable.name,
    }));
  }

  #viewControls() {
    const { edges, linked } = this.settings;
    return html`
      <label>
        <input type="checkbox" .checked=${edges} @change=${(event: Event) => this.#change({ edges: ticked(event) })} />
        Edges
      </label>
      <label>
        <input type="checkbox" .checked=${linked} @change=${(event: Event) => this.#change({ unlinked: !ticked(event) })} />
        One camera
      </label>
      <button @click=${() => this.dispatchEvent(new CustomEvent('fit'))}>Fit</button>
    `;
  }

  #browse(): void {
    this.renderRoot.querySelector<HTMLInputElement>('input[type=file]')?.click();
  }

  #openFile({ target }: Event): void {
    const input = target as HTMLInputElement;
    const file = input.files?.[0];
    // Emptied, so that choosing the same file again is a change.
    input.value = '';
    if (file) this.dispatchEvent(new CustomEvent('open-file', { detail: file }));
  }

  #openSample(event: Event): void {
    const sample = this.samples.find(({ name }) => name === chosen(event));
    if (sample) this.dispatchEvent(new CustomEvent('open-sample', { detail: sample }));
  }

  #change(detail: Partial<WantedView>): void {
    this.dispatchEvent(new CustomEvent('view-change', { detail }));
  }
}

function chosen({ target }: Event): string {
  return (target as HTMLSelectElement).value;
}

function ticked({ target }: Event): boolean {
  return (target as HTMLInputElement).checked;
}

customElements.define('meshbound-toolbar', Toolbar);
