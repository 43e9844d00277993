#include "overlap.hpp"

#include "plane.hpp"

namespace meshbound {

bool holds_candidate(const Hole& hole, int a, int b) {
    if (b == a + 1) return false;
    if (a == 0 && b == hole.size() - 1) return true;
    const auto place = [&](int i) { return hole.places[static_cast<std::size_t>(i)]; };
    return orientation(place(a), place(b), glm::dvec2(0)) < 0;
}

bool holds_candidate(const Hole& hole, int a, int m, int b) {
    return holds_candidate(hole, a, b) && !holds_candidate(hole, a, m) && !holds_candidate(hole, m, b);
}

RingRun crossed_spokes(const Hole& hole, int a, int b) {
    const int size = hole.size();
    if (b == a + 1 || (a == 0 && b == size - 1)) return {};
    if (!holds_candidate(hole, a, b)) return {a + 1, b - a - 1};
    return {hole.after(b), size - (b - a) - 1};
}

RingRun overlapped_sectors(const Hole& hole, int a, int m, int b) {
    const int size = hole.size();
    if (!holds_candidate(hole, a, b)) return {a, b - a};
    if (holds_candidate(hole, a, m)) return {m, size - (m - a)};
    if (holds_candidate(hole, m, b)) return {b, size - (b - m)};
    return {0, hole.sectors()};
}

} // namespace meshbound
