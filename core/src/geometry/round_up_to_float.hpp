#pragma once

#include <cmath>
#include <limits>

namespace meshbound {

/// Rounded up, so that the single-precision number is still an upper bound.
inline float round_up_to_float(double value) {
    const auto rounded = static_cast<float>(value);
    return rounded < value ? std::nextafter(rounded, std::numeric_limits<float>::infinity()) : rounded;
}

} // namespace meshbound
