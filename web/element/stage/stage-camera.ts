import { type CameraPlace, type LinkedCameras, parsePlaces, placesText } from '../../viewer/linked-cameras.ts';

/** Where the camera of a stage stands, or both of them, as text; it can be said before there is anything to look at. */
export class StageCamera {
  /** Where they are to stand when a surface comes; null fits it into view. */
  #wanted: CameraPlace[] | null = null;
  /** Whether they are still to be put there: not before it is known whether they are linked. */
  #isDue = false;
  #told: string | null = null;

  get isDue(): boolean {
    return this.#isDue;
  }

  /** Null, and what is no place, fits everything into view. */
  want(text: string | null): void {
    this.#wanted = text === null ? null : parsePlaces(text);
    this.#isDue = true;
  }

  /** Puts the cameras where they are wanted, for another surface, too. */
  apply(cameras: LinkedCameras): void {
    this.#isDue = false;
    cameras.fit();
    const [first, second = first] = this.#wanted ?? [];
    if (first) cameras.setPlace(0, first);
    if (second && !cameras.linked) cameras.setPlace(1, second);
  }

  /** Null where everything is fitted into view. */
  text(cameras: LinkedCameras | undefined): string | null {
    if (this.#isDue) return this.#wanted && placesText(this.#wanted);
    if (!cameras || cameras.fitted) return null;
    return placesText((cameras.linked ? [0] : [0, 1]).map((side) => cameras.place(side)));
  }

  /** Whether this is another text than the last that was asked about: one tells of it once. */
  isNew(text: string | null): boolean {
    const told = this.#told;
    this.#told = text;
    return text !== told;
  }
}
