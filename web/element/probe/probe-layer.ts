import { css, html, LitElement, nothing } from 'lit';
import type { Labels } from '../../formats/surface.ts';
import { largestShare } from '../../probe/probe.ts';
import { nothingProbed, type ProbeState } from '../../session/probing.ts';
import { controlsStyle } from '../controls/controls-style.ts';
import { usedShareText } from '../number-text.ts';
import type { ProbeCard } from './probe-card.ts';
import './probe-card.ts';
import { english } from '../../words/english.ts';
import type { Marker } from './stage-probe.ts';

/** Between the card and the edge of the stage, and between it and a marker that it must not hide, in CSS pixels. */
const margin = 10;

const corners = ['top right', 'bottom right', 'top left', 'bottom left'] as const;
type Corner = (typeof corners)[number];

/**
 * What lies over the surfaces while they are probed: a marker on each of them, and the card with what stands there, in a
 * corner where it hides no marker.
 *
 * @fires worst-wanted with the name of a variable
 * @fires unpin
 */
export class ProbeLayer extends LitElement {
  static override properties = {
    state: { attribute: false },
    labels: { attribute: false },
    markers: { attribute: false },
    provisional: { type: Boolean },
  };

  static override styles = [
    controlsStyle,
    css`
      :host {
        position: absolute;
        inset: 0;
        overflow: hidden;
        pointer-events: none;
      }
      .marker {
        position: absolute;
        width: 13px;
        height: 13px;
        margin: -6.5px;
        border: 2px solid #fff;
        border-radius: 50%;
        outline: 1.5px solid #000;
        box-shadow: inset 0 0 0 1.5px #000;
      }
      .marker.hidden {
        border-style: dotted;
        opacity: 0.6;
      }
      meshbound-probe-card {
        position: absolute;
        width: min(420px, 100% - 20px);
        max-height: calc(100% - 20px);
        overflow-y: auto;
      }
    `,
  ];

  declare state: ProbeState;
  declare labels: Labels | null;
  declare markers: readonly Marker[];
  /** Another reduction takes the place of the one that is probed as soon as it is there. */
  declare provisional: boolean;
  #corner: Corner = corners[0];

  constructor() {
    super();
    this.state = nothingProbed;
    this.labels = null;
    this.markers = [];
    this.provisional = false;
  }

  override render() {
    const { probe, pinned } = this.state;
    return html`
      ${this.markers.map(
        ({ side, x, y, hidden }) =>
          html`<div class="marker ${side} ${hidden ? 'hidden' : ''}" part="marker" .style=${`left:${x}px;top:${y}px`}></div>`,
      )}
      ${
        probe
          ? html`<meshbound-probe-card
              part="probe"
              role="group"
              aria-label=${english.probe.name}
              ?pinned=${pinned}
              .state=${this.state}
              .labels=${this.labels}
              @worst-wanted=${({ detail }: CustomEvent<string>) =>
                this.dispatchEvent(new CustomEvent('worst-wanted', { detail }))}
              @unpin=${() => this.dispatchEvent(new CustomEvent('unpin'))}
            ></meshbound-probe-card>`
          : nothing
      }
      <div class="unseen" role="status">${this.#spoken()}</div>
    `;
  }

  /** Not while the pointer moves, or a bound: it would never end. */
  #spoken(): string {
    const { probe, pinned, pending } = this.state;
    if (!probe || !pinned || pending || this.provisional) return '';
    const most = largestShare(probe);
    return most ? english.probe.largest(most.name, usedShareText(most.ratio ?? 0)) : english.probe.unknown;
  }

  override async updated(): Promise<void> {
    const card = this.renderRoot.querySelector<ProbeCard>('meshbound-probe-card');
    if (!card) return;
    await card.updateComplete;
    this.#corner = this.#freeCorner(card.offsetWidth, card.offsetHeight);
    for (const edge of ['top', 'right', 'bottom', 'left']) {
      card.style.setProperty(edge, this.#corner.includes(edge) ? `${margin}px` : 'auto');
    }
  }

  /** The corner where it hides the fewest markers; the one where it is, if that is among them. */
  #freeCorner(width: number, height: number): Corner {
    const hidden = (corner: Corner) =>
      this.markers.filter((marker) => this.#isUnder(marker, corner, width, height)).length;
    return [this.#corner, ...corners].reduce((best, next) => (hidden(next) < hidden(best) ? next : best));
  }

  #isUnder({ x, y }: Marker, corner: Corner, width: number, height: number): boolean {
    const [reachX, reachY] = [width + 2 * margin, height + 2 * margin];
    const across = corner.includes('left') ? x < reachX : x > this.clientWidth - reachX;
    const down = corner.includes('top') ? y < reachY : y > this.clientHeight - reachY;
    return across && down;
  }
}

customElements.define('meshbound-probe-layer', ProbeLayer);
