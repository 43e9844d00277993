#pragma once

#include "geometry/plane.hpp"
#include "surface/hole.hpp"

namespace meshbound {

/// How old and new triangles of a laid-out hole overlap (§3.2, figure 5), by ring indices alone: which spokes a
/// diagonal crosses and which sectors a new triangle overlaps. All of it follows from one predicate, on which side of a
/// diagonal the candidate lies, so it is consistent whatever rounding does.

/// Whether the candidate lies in the sub-polygon a … b (a < b) that the diagonal (a, b) cuts off.
inline bool contains_candidate(const Hole& hole, int a, int b) {
    if (b == a + 1) return false;
    if (a == 0 && b == hole.size() - 1) return true;
    const auto at_ring = [&](int i) { return hole.layout[static_cast<std::size_t>(i)]; };
    return orientation(at_ring(a), at_ring(b), glm::dvec2(0)) < 0;
}

/// Whether the candidate lies in the triangle a < m < b.
inline bool contains_candidate(const Hole& hole, int a, int m, int b) {
    return contains_candidate(hole, a, b) && !contains_candidate(hole, a, m) && !contains_candidate(hole, m, b);
}

/// `count` consecutive ring indices from `first` on, cyclically.
struct RingRange {
    int first = 0, count = 0;
};

/// Spokes crossed by the diagonal (a, b), a < b. Link edges and the closing edge cross none.
inline RingRange crossed_spokes(const Hole& hole, int a, int b) {
    const int size = hole.size();
    if (b == a + 1 || (a == 0 && b == size - 1)) return {};
    if (!contains_candidate(hole, a, b)) return {a + 1, b - a - 1};
    return {hole.after(b), size - (b - a) - 1};
}

/// Sectors that the triangle a < m < b overlaps.
RingRange overlapped_sectors(const Hole& hole, int a, int m, int b);

} // namespace meshbound
