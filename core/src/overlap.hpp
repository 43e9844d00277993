#pragma once

#include "hole.hpp"

namespace meshbound {

/// How old and new triangles of a laid-out hole overlap (§3.2, figure 5), by ring positions alone: which spokes a diagonal
/// crosses and which sectors a new triangle reaches. All decisions come from one question, on which side of a diagonal the
/// candidate lies, so they never contradict each other, whatever rounding does.

/// Whether the candidate lies in the sub-polygon a … b (a < b) that the diagonal (a, b) cuts off.
bool holds_candidate(const Hole& hole, int a, int b);

/// Whether the candidate lies in the triangle a < m < b.
bool holds_candidate(const Hole& hole, int a, int m, int b);

/// `count` consecutive ring positions from `first` on, around the ring.
struct RingRun {
    int first = 0, count = 0;
};

/// Spokes crossed by the diagonal (a, b), a < b. Rims and the closing edge cross none.
RingRun crossed_spokes(const Hole& hole, int a, int b);

/// Sectors that the triangle a < m < b overlaps.
RingRun overlapped_sectors(const Hole& hole, int a, int m, int b);

} // namespace meshbound
