interface Numbers extends ArrayLike<number> {
  set(values: ArrayLike<number>, at: number): void;
}

/** All parts one after the other, in one array of a type that holds their numbers. */
export function joined<All extends Numbers>(parts: ArrayLike<number>[], type: new (length: number) => All): All {
  const all = new type(parts.reduce((sum, part) => sum + part.length, 0));
  let at = 0;
  for (const part of parts) {
    all.set(part, at);
    at += part.length;
  }
  return all;
}
