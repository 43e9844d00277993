#pragma once

#include <algorithm>

namespace meshbound {

/// Holds the signed error of every point that was ever mapped into a triangle, in one component.
struct ErrorInterval {
    double lowest = 0, highest = 0;

    void include(const ErrorInterval& other) {
        lowest = std::min(lowest, other.lowest);
        highest = std::max(highest, other.highest);
    }
    double magnitude() const { return std::max(-lowest, highest); }
};

} // namespace meshbound
