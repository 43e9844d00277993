import { css } from 'lit';

/** How groups of the panel look that are closed at first, with a summary of what is set in them. */
export const groupStyle = css`
  :host {
    display: block;
  }
  summary {
    border-radius: var(--radius);
    cursor: pointer;
  }
  label {
    display: flex;
    gap: var(--gap);
    align-items: center;
    justify-content: space-between;
    margin-top: 6px;
  }
  label.tick {
    justify-content: start;
  }
  label > span {
    white-space: nowrap;
  }
  select {
    width: 198px;
    min-width: 0;
  }
  p {
    margin-top: 6px;
  }
  .places {
    display: grid;
    grid-template-columns: auto repeat(3, minmax(0, 1fr));
    /* What is said below a row leaves no hole in it. */
    grid-auto-flow: row dense;
    gap: 4px 6px;
    align-items: center;
    margin-top: 6px;
  }
  input[type='text'] {
    width: 100%;
    min-width: 0;
    padding: 2px 4px;
    font-size: var(--text-small);
  }
  input[aria-invalid='true'] {
    border-color: var(--fault);
  }
  button {
    margin-top: 6px;
  }
`;
