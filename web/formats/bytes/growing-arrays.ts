import type { Polygons } from '../faces/polygons.ts';

const firstRoom = 1024;

/** Doubles whose number is not known beforehand. */
export class GrowingNumbers {
  private values = new Float64Array(firstRoom);
  length = 0;

  push(number: number): void {
    if (this.length === this.values.length) {
      const larger = new Float64Array(2 * this.length);
      larger.set(this.values);
      this.values = larger;
    }
    this.values[this.length++] = number;
  }

  /** A copy of all that was pushed. */
  toArray(): Float64Array {
    return this.values.slice(0, this.length);
  }
}

/** Indices whose number is not known beforehand. */
export class GrowingIndices {
  private values = new Uint32Array(firstRoom);
  length = 0;

  push(index: number): void {
    if (this.length === this.values.length) {
      const larger = new Uint32Array(2 * this.length);
      larger.set(this.values);
      this.values = larger;
    }
    this.values[this.length++] = index;
  }

  /** A copy of all that was pushed. */
  toArray(): Uint32Array {
    return this.values.slice(0, this.length);
  }
}

/** Polygons while they are read. */
export class GrowingPolygons {
  private corners = new GrowingIndices();
  private ends = new GrowingIndices();

  addCorner(corner: number): void {
    this.corners.push(corner);
  }

  endPolygon(): void {
    this.ends.push(this.corners.length);
  }

  toPolygons(): Polygons {
    return { corners: this.corners.toArray(), ends: this.ends.toArray() };
  }
}
