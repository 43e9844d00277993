/** The bounds of the levels: of the geometry in percent of its extent; of every variable three times that. */
export const percents = [1, 2, 4, 8];

/** The way from a level to the next. */
export interface WatchedStep {
  /** Triangles of both levels and of the morph between them. */
  finer: number;
  coarser: number;
  pieces: number;
  /** How many of the pieces are folded. */
  folded: number;
  /** What a frame asks of the graphics card, and what lies there for it. */
  calls: number;
  vertices: number;
  bytes: number;
  seen: Seen;
}

/** What is seen on the way. */
export interface Seen {
  /** The shares of the surface's pixels that change visibly from one frame to the next: the median and the largest. */
  usual: number;
  most: number;
  /** How far colours go beyond the way from their first to their last, in 1/255, in the mean over the surface's pixels. */
  detour: number;
  /**
   * Of closed surfaces, which show their back only where they are folded: the largest share of their pixels that change once
   * backs are not drawn, and how many pixels of a frame at most are background then, and were not before. Else null.
   */
  backs: { folds: number; holes: number } | null;
}
