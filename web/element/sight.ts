/** How near to the part of the page in sight something counts as in sight: so that it is there when one comes to it. */
const margin = '200px';

/** Waits until an element comes near the part of the page in sight, for what would be done in vain before. */
export class Sight {
  #observer: IntersectionObserver | null = null;

  /** Calls `inSight` once the element comes near. */
  wait(element: Element, inSight: () => void): void {
    const observer = new IntersectionObserver(
      (entries) => {
        if (!entries.some(({ isIntersecting }) => isIntersecting)) return;
        observer.disconnect();
        inSight();
      },
      { rootMargin: margin },
    );
    this.#observer = observer;
    observer.observe(element);
  }

  /** Waits no longer. */
  stop(): void {
    this.#observer?.disconnect();
  }
}
