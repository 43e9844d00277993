#pragma once

#include "surface/hole.hpp"
#include "geometry/plane.hpp"

namespace meshbound {

/// How old and new triangles of a laid-out hole overlap (§3.2, figure 5), by ring positions alone: which spokes a diagonal
/// crosses and which sectors a new triangle reaches. All decisions come from one question, on which side of a diagonal the
/// candidate lies, so they never contradict each other, whatever rounding does.

/// Whether the candidate lies in the sub-polygon a … b (a < b) that the diagonal (a, b) cuts off.
inline bool holds_candidate(const Hole& hole, int a, int b) {
    if (b == a + 1) return false;
    if (a == 0 && b == hole.size() - 1) return true;
    const auto place = [&](int i) { return hole.places[static_cast<std::size_t>(i)]; };
    return orientation(place(a), place(b), glm::dvec2(0)) < 0;
}

/// Whether the candidate lies in the triangle a < m < b.
inline bool holds_candidate(const Hole& hole, int a, int m, int b) {
    return holds_candidate(hole, a, b) && !holds_candidate(hole, a, m) && !holds_candidate(hole, m, b);
}

/// `count` consecutive ring positions from `first` on, around the ring.
struct RingRun {
    int first = 0, count = 0;
};

/// Spokes crossed by the diagonal (a, b), a < b. Rims and the closing edge cross none.
inline RingRun crossed_spokes(const Hole& hole, int a, int b) {
    const int size = hole.size();
    if (b == a + 1 || (a == 0 && b == size - 1)) return {};
    if (!holds_candidate(hole, a, b)) return {a + 1, b - a - 1};
    return {hole.after(b), size - (b - a) - 1};
}

/// Sectors that the triangle a < m < b overlaps.
RingRun overlapped_sectors(const Hole& hole, int a, int m, int b);

} // namespace meshbound
