#pragma once

#include <cmath>
#include <limits>

namespace meshbound {

/// Rounded up, so that the single-precision figure is still a bound.
inline float upper_float(double value) {
    const auto rounded = static_cast<float>(value);
    return rounded < value ? std::nextafter(rounded, std::numeric_limits<float>::infinity()) : rounded;
}

} // namespace meshbound
