import { css, html, LitElement } from 'lit';
import { live } from 'lit/directives/live.js';
import { valueColormaps } from '../../colour/colormaps.ts';
import { parseRange } from '../../colour/colour-range.ts';
import { componentsOf } from '../../colour/field.ts';
import type { BoundSettings } from '../../session/bounds/bound-setting.ts';
import type { OpenSurface } from '../../session/reading/open-surface.ts';
import { viewDirections } from '../../viewer/linked-cameras.ts';
import { controlsStyle } from './controls-style.ts';
import './cut-choice.ts';
import { english } from '../../words/english.ts';
import {
  firstView,
  hasSign,
  type Quantity,
  type ViewSettings,
  views,
  type WantedView,
} from '../attributes/view-settings.ts';

/** The maps that errors always have. */
const errorMaps: Record<Exclude<Quantity, 'value'>, string> = { error: 'YlOrBr', 'signed-error': 'RdBu' };

/** Ranges to choose from, beside those that one types. */
const offeredRanges = ['data', '1%…99%', '2%…98%', '5%…95%'];

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
 * @fires look-from with a ViewDirection
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
        width: 134px;
      }
      select.narrow {
        width: 96px;
      }
      [popover] {
        inset: auto;
        width: max-content;
        margin: 0;
        padding: 10px 12px;
        color: var(--ink);
        background: var(--panel);
        border: 1px solid var(--control-line);
        border-radius: var(--radius);
        box-shadow: 0 2px 8px rgb(0 0 0 / 15%);
      }
      [popover] label {
        display: flex;
        margin-bottom: 6px;
      }
      [popover] input[type='text'] {
        flex: 1;
        width: 120px;
      }
      [popover] [aria-invalid='true'] {
        border-color: var(--fault);
      }
      .axes {
        display: grid;
        grid-template-columns: repeat(6, 1fr);
        gap: 4px;
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
      <label><span class="soft">${english.view.colour}</span>${this.#variableChoice()}</label>
      <label><span class="soft">${english.view.show}</span>${this.#quantityChoice()}</label>
      <label title=${quantity === 'value' ? '' : english.view.ownMaps}>
        <span class="soft">${english.view.map}</span>
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
      ${Object.entries(english.view.quantities).map(
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
        view: { variable: variable.name, component: variable.components === 1 ? null : label },
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
    return html`
      <label>
        <span class="soft">${english.view.view}</span>
        <select class="middle" @change=${(event: Event) => this.#change({ view: chosen(event) })}>
          ${views.map(
            (view) =>
              html`<option value=${view} .selected=${live(view === this.settings.view)}>${english.view.views[view]}</option>`,
          )}
        </select>
      </label>
      ${this.#tick(english.view.edges, this.settings.edges, (edges) => ({ edges }))}
      ${this.#tick(english.view.oneCamera, this.settings.linked, (linked) => ({ unlinked: !linked }))}
      <button popovertarget="more" @click=${this.#place}>${english.view.more}</button>
      <div id="more" popover @toggle=${this.#place}>${this.#moreControls()}</div>
      <button @click=${() => this.dispatchEvent(new CustomEvent('fit'))}>${english.view.fit}</button>
    `;
  }

  #moreControls() {
    const { flat, doubleSided, orthographic, range, clip, quantity } = this.settings;
    return html`
      ${this.#tick(english.view.flat, flat, (now) => ({ flat: now }))}
      ${this.#tick(english.view.bothSides, doubleSided, (both) => ({ cull: !both }))}
      ${this.#tick(english.view.parallel, orthographic, (now) => ({ orthographic: now }))}
      <label>
        ${english.view.range}
        <input
          type="text"
          list="ranges"
          placeholder=${firstView.range}
          title=${english.view.rangeHint}
          .value=${range === firstView.range ? '' : range}
          ?disabled=${quantity !== 'value'}
          @change=${this.#typeRange}
        />
        <datalist id="ranges">${offeredRanges.map((range) => html`<option value=${range}></option>`)}</datalist>
      </label>
      <meshbound-cut-choice
        .surface=${this.surface}
        .clip=${clip}
        @clip-change=${({ detail }: CustomEvent<string | null>) => this.#change({ clip: detail })}
      ></meshbound-cut-choice>
      <div class="axes" role="group" aria-label=${english.view.axes}>
        ${Object.keys(viewDirections).map(
          (direction) => html`<button
            aria-label=${english.view.from(direction)}
            @click=${() => this.dispatchEvent(new CustomEvent('look-from', { detail: direction }))}
          >
            ${direction.replace('-', '\u2212')}
          </button>`,
        )}
      </div>
    `;
  }

  #tick(text: string, on: boolean, wanted: (on: boolean) => Partial<WantedView>) {
    return html`<label>
      <input type="checkbox" .checked=${live(on)} @change=${(event: Event) => this.#change(wanted(ticked(event)))} />
      ${text}
    </label>`;
  }

  /** Takes what was typed where it can be understood; else the field says that it cannot. */
  #typeRange({ target }: Event): void {
    const input = target as HTMLInputElement;
    const text = input.value.trim();
    const understood = parseRange(text) !== null;
    input.setAttribute('aria-invalid', String(!understood));
    if (understood) this.#change({ range: text || null });
  }

  /** Below its button, inside the window. */
  #place(): void {
    const list = this.renderRoot.querySelector('#more') as HTMLElement;
    const button = this.renderRoot.querySelector('[popovertarget=more]')?.getBoundingClientRect();
    if (!button) return;
    list.style.top = `${button.bottom + 4}px`;
    list.style.left = `${Math.max(4, Math.min(button.left, innerWidth - list.offsetWidth - 4))}px`;
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
