/**
 * The port to serve the page on: what the variable PORT of the environment says, so that two checkouts can be tested or
 * measured at once, or else `first`. Throws an error that names the variable where that is no port.
 */
export function portOr(first: number, { PORT }: NodeJS.ProcessEnv = process.env): number {
  if (PORT === undefined) return first;
  const port = Number(PORT);
  if (!/^\d+$/.test(PORT) || port < 1 || port > 65_535) {
    throw new Error(`PORT: "${PORT}" is no port: a whole number from 1 to 65535.`);
  }
  return port;
}
