import { css } from 'lit';

/** How panes, captions and the divider lie on a stage. */
export const stageStyle = css`
  :host {
    display: block;
    position: relative;
    container-type: size;
    background: var(--stage);
    overflow: hidden;
  }
  canvas {
    position: absolute;
    width: 100%;
    height: 100%;
  }
  .panes {
    position: absolute;
    inset: 0;
    display: grid;
    grid-template-columns: 1fr 1fr;
    gap: 1px;
  }
  @container (max-aspect-ratio: 1/1) {
    .panes {
      grid-template: 1fr 1fr / none;
    }
  }
  .panes.original,
  .panes.reduced,
  .panes.morph,
  .panes.wipe {
    grid-template: 1fr / 1fr;
  }
  .panes.original #reduced,
  .panes.reduced #original,
  .panes.morph #original {
    display: none;
  }
  .panes.wipe .pane {
    grid-area: 1 / 1;
    box-shadow: none;
  }
  .panes.wipe #reduced {
    align-items: end;
  }
  .panes.wipe #reduced .caption {
    align-self: end;
  }
  /* One over the other, two legends share the width. */
  .panes.wipe meshbound-legend {
    max-width: calc(50% - 4px);
  }
  .divider {
    position: absolute;
    top: 0;
    bottom: 0;
    width: 24px;
    transform: translateX(-50%);
    cursor: ew-resize;
    touch-action: none;
    background: linear-gradient(var(--accent) 0 0) 50% / 2px 100% no-repeat;
  }
  .divider::after {
    content: '';
    position: absolute;
    top: calc(50% - 18px);
    left: 6px;
    width: 12px;
    height: 36px;
    background: var(--control);
    border: 2px solid var(--accent);
    border-radius: var(--radius);
  }
  .pane {
    display: flex;
    flex-direction: column;
    justify-content: space-between;
    min-width: 0;
    min-height: 0;
    padding: 10px;
    outline-offset: -2px;
    cursor: grab;
  }
  .pane:active {
    cursor: grabbing;
  }
  .pane + .pane {
    box-shadow: -1px 0 var(--line), 0 -1px var(--line);
  }
  .pane > * {
    pointer-events: none;
  }
  .caption {
    align-self: start;
    max-width: 100%;
    padding: 2px 8px;
    background: var(--veil);
    border-radius: var(--radius);
  }
  .caption b {
    font-weight: 600;
  }
`;
