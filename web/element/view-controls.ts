import { css, html, LitElement } from 'lit';
import { live } from 'lit/directives/live.js';
import { valueColormaps } from '../colour/colormaps.ts';
import { componentsOf } from '../colour/field.ts';
import type { BoundSettings } from '../session/bound-setting.ts';
import type { OpenSurface } from '../session/session.ts';
import { controlsStyle } from './controls-style.ts';
import { firstView, hasSign, type Quantity, type ViewSettings, type WantedView } from './view-settings.ts';

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
 * Colours and view, as parts of the bar (a container of this name) that they stand in.
 *
 * @fires view-change with what is wanted now: a Partial<WantedView>
 * @fires fit
 */
export class ViewControls extends LitElement {
  static override properties = {
    surface: { attribute: false },
    bounds: { attribute: false },
    settings: { attribute: false },
  };

  static override styles = [
    controlsStyle,
    css`
      :host {
        display: contents;
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
        width: 122px;
        text-overflow: ellipsis;
      }
      select.middle {
        width: 122px;
      }
      select.narrow {
        width: 96px;
      }
      @container bar (max-width: 800px) {
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

  declare surface: OpenSurface | null;
  declare bounds: BoundSettings;
  declare settings: ViewSettings;

  constructor() {
    super();
    this.surface = null;
    this.bounds = {};
    this.settings = firstView;
  }

  override render() {
    return html`
      <div class="group">${this.#colourControls()}</div>
      <div class="group view">${this.#viewControls()}</div>
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

customElements.define('meshbound-view-controls', ViewControls);
