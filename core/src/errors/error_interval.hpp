#pragma once

#include <algorithm>

namespace meshbound {

/// An interval that contains the signed errors, in one component, of all points that were ever mapped into a triangle.
struct ErrorInterval {
    double lowest = 0, highest = 0;

    void include(const ErrorInterval& other) {
        lowest = std::min(lowest, other.lowest);
        highest = std::max(highest, other.highest);
    }
    double magnitude() const { return std::max(-lowest, highest); }
};

} // namespace meshbound
