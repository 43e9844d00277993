#include "retriangulation/overlap.hpp"

namespace meshbound {

RingRange overlapped_sectors(const Hole& hole, int a, int m, int b) {
    const int size = hole.size();
    if (!contains_candidate(hole, a, b)) return {a, b - a};
    if (contains_candidate(hole, a, m)) return {m, size - (m - a)};
    if (contains_candidate(hole, m, b)) return {b, size - (b - m)};
    return {0, hole.sectors()};
}

} // namespace meshbound
