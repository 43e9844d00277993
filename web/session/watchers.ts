/** What a task that takes a while gets from who waits for it. */
export interface Watchers {
  signal?: AbortSignal;
  /** Called with the progress, 0…1, never falling, where it is known. */
  onProgress?: (progress: number) => void;
}
