import { css } from 'lit';

/**
 * Every colour and measure that more than one part uses; custom properties reach into shadow trees. Each can be set from
 * outside by the name behind `--meshbound-`. Light or dark is as the page around says by `color-scheme`.
 */
export const tokens = css`
  :host {
    --panel: var(--meshbound-panel, light-dark(#ffffff, #1f2224));
    --stage: var(--meshbound-stage, light-dark(#e4e6e8, #2d3134));
    --line: var(--meshbound-line, light-dark(#d3d6d9, #43484c));
    --control-line: var(--meshbound-control-line, light-dark(#7d848b, #7c838a));
    --control: var(--meshbound-control, light-dark(#ffffff, #282c2f));
    --control-hover: var(--meshbound-control-hover, light-dark(#eef0f2, #32373b));
    --ink: var(--meshbound-ink, light-dark(#1b1e21, #e8eaec));
    --ink-soft: var(--meshbound-ink-soft, light-dark(#565d64, #a5acb3));
    --accent: var(--meshbound-accent, light-dark(#1a5fb4, #78aeed));
    --accent-soft: var(--meshbound-accent-soft, light-dark(#bcd2ec, #2c4867));
    --fault: var(--meshbound-fault, light-dark(#a51d2d, #f6a5ab));
    --fault-soft: var(--meshbound-fault-soft, light-dark(#fbe9eb, #3a2124));
    --veil: var(--meshbound-veil, light-dark(rgb(255 255 255 / 82%), rgb(23 25 27 / 80%)));

    --gap: var(--meshbound-gap, 8px);
    --radius: var(--meshbound-radius, 4px);
    --text: var(--meshbound-text, 14px);
    --text-small: var(--meshbound-text-small, 12.5px);

    color: var(--ink);
    font: var(--text) / 1.4
      var(--meshbound-font, system-ui, -apple-system, 'Segoe UI', Roboto, 'Noto Sans', sans-serif);
    font-variant-numeric: tabular-nums;
  }
`;
