/**
 * Stands for a place in a map where there is none to show, at all three corners of a triangle. So far below any place
 * of a value that a range typed by hand could leave outside that the two cannot be taken for each other.
 */
export const missingPlace = -1e30;
