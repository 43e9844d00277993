import { html, type LitElement } from 'lit';
import { english } from '../../words/english.ts';

/** How far a press of a key moves it. */
const step = 0.02;

const steps: Record<string, number> = { ArrowLeft: -step, ArrowRight: step, Home: -1, End: 1 };

/** Where one surface ends and the other begins when one lies over the other: moved by pointer or keys. */
export class StageDivider {
  /** From the left of the stage, 0…1. */
  place = 0.5;
  #stage: LitElement;
  #moved: () => void;

  /** @param moved called when it stands at another place */
  constructor(stage: LitElement, moved: () => void) {
    this.#stage = stage;
    this.#moved = moved;
  }

  handle() {
    const percent = Math.round(100 * this.place);
    return html`<div
      class="divider"
      part="divider"
      role="slider"
      tabindex="0"
      aria-label=${english.stage.divider}
      aria-valuemin="0"
      aria-valuemax="100"
      aria-valuenow=${percent}
      aria-valuetext=${english.stage.dividerAt(percent)}
      .style=${`left:${100 * this.place}%`}
      @pointerdown=${(event: PointerEvent) => (event.target as Element).setPointerCapture(event.pointerId)}
      @pointermove=${(event: PointerEvent) => this.#drag(event)}
      @keydown=${(event: KeyboardEvent) => this.#press(event)}
    ></div>`;
  }

  #drag({ target, pointerId, clientX }: PointerEvent): void {
    if (!(target as Element).hasPointerCapture(pointerId)) return;
    const { left, width } = this.#stage.getBoundingClientRect();
    this.#moveTo((clientX - left) / width);
  }

  #press(event: KeyboardEvent): void {
    if (!(event.key in steps)) return;
    event.preventDefault();
    this.#moveTo(this.place + steps[event.key]);
  }

  #moveTo(place: number): void {
    this.place = Math.min(1, Math.max(0, place));
    this.#stage.requestUpdate();
    this.#moved();
  }
}
