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
    gap: 4px 6px;
    align-items: center;
    margin-top: 6px;
  }
  input[type='number'],
  input[type='text'] {
    width: 100%;
    min-width: 0;
    min-height: 28px;
    padding: 2px 4px;
    font-size: var(--text-small);
    /* The arrow keys do what its arrows would, which take the room of the number. */
    appearance: textfield;
    background: var(--control);
    border: 1px solid var(--control-line);
    border-radius: var(--radius);
  }
  input[aria-invalid='true'] {
    border-color: var(--fault);
  }
  button {
    margin-top: 6px;
  }
`;
