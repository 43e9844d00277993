import { css } from 'lit';

/** How the parts of a viewer lie around its stage. */
export const viewerStyle = css`
  /* Whatever display the page around gives the host, its parts lie in a frame of their own. */
  :host {
    display: block;
    position: relative;
    min-height: 120px;
    aspect-ratio: 2;
    background: var(--panel);
  }
  .frame {
    position: absolute;
    inset: 0;
    display: flex;
    flex-direction: column;
  }
  /* How wide it is where the page leaves that to the content. */
  .width {
    width: 640px;
    max-width: 100%;
  }
  /* High enough to stack the surfaces: side by side, captions and legends would cover them. */
  @media (max-width: 600px) {
    :host {
      aspect-ratio: 4 / 5;
    }
  }
  :host([hidden]) {
    display: none;
  }
  .stage {
    position: relative;
    flex: 1;
    min-height: 0;
  }
  meshbound-stage,
  .poster {
    position: absolute;
    inset: 0;
  }
  .poster {
    display: grid;
    place-items: center;
    overflow: hidden;
  }
  .poster img {
    width: 100%;
    height: 100%;
    object-fit: contain;
  }
  meshbound-notices {
    position: absolute;
    z-index: 1;
    top: 50px;
    left: 50%;
    width: min(620px, 100% - 24px);
    transform: translateX(-50%);
  }
  .progress {
    position: absolute;
    bottom: 0;
    left: 0;
    height: 2px;
    background: var(--accent);
  }
  .controls {
    display: flex;
    flex-wrap: wrap;
    gap: var(--gap) 16px;
    align-items: center;
    padding: 8px 12px;
    border-bottom: 1px solid var(--line);
    container: bar / inline-size;
  }
  .all {
    display: flex;
    flex: 1 1 200px;
    gap: var(--gap);
    align-items: center;
  }
  meshbound-bound-slider {
    flex: 1;
  }
  meshbound-result-bar {
    padding: 8px 12px;
    border-top: 1px solid var(--line);
  }
`;
