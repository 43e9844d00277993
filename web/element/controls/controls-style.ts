import { css } from 'lit';

/** How buttons, choices and fields look everywhere. */
export const controlsStyle = css`
  *,
  *::before {
    box-sizing: border-box;
  }

  button,
  select,
  input {
    font: inherit;
    font-variant-numeric: inherit;
    color: inherit;
    accent-color: var(--accent);
  }

  button,
  select,
  input:not([type]),
  input[type='text'] {
    min-height: 28px;
    padding: 2px 8px;
    background: var(--control);
    border: 1px solid var(--control-line);
    border-radius: var(--radius);
  }

  button,
  select {
    cursor: pointer;
  }

  button:hover:enabled,
  select:hover:enabled {
    background: var(--control-hover);
  }

  :disabled {
    cursor: default;
    opacity: 0.55;
  }

  :focus-visible {
    outline: 2px solid var(--accent);
    outline-offset: 1px;
  }

  h1,
  h2,
  p {
    margin: 0;
    font-size: inherit;
  }

  /* Large enough for fingers (WCAG 2.2, 2.5.8). */
  @media (any-pointer: coarse), (max-width: 800px) {
    label,
    summary {
      min-height: 24px;
    }
  }

  .soft {
    color: var(--ink-soft);
  }

  .small {
    font-size: var(--text-small);
  }

  /* For screen readers alone. */
  .unseen {
    position: absolute;
    width: 1px;
    height: 1px;
    overflow: hidden;
    clip-path: inset(50%);
    white-space: nowrap;
  }
`;
