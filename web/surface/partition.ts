/** Union-find over the numbers 0 … size − 1: every number alone at first. */
export class Partition {
  readonly size: number;
  private readonly parents: Uint32Array;

  constructor(size: number) {
    this.size = size;
    this.parents = new Uint32Array(size).map((_, element) => element);
  }

  /** The number that stands for the part of `element`. */
  root(element: number): number {
    const { parents } = this;
    let here = element;
    while (parents[here] !== here) {
      parents[here] = parents[parents[here]];
      here = parents[here];
    }
    return here;
  }

  join(one: number, other: number): void {
    this.parents[this.root(one)] = this.root(other);
  }

  /** In how many parts the elements lie. */
  count(elements: Iterable<number>): number {
    const roots = new Uint8Array(this.size);
    for (const element of elements) roots[this.root(element)] = 1;
    return roots.reduce((sum, each) => sum + each, 0);
  }
}
