#include "metric/rounding_margin.hpp"

#include <cmath>
#include <limits>

namespace meshbound {
namespace {

/// Operations between a stored value and the error that is compared with its bound, each rounding once.
constexpr double operations = 64;

} // namespace

double rounding_margin(const ResolvedBound& bound) {
    if (std::isinf(bound.absolute)) return 0;
    return operations * std::numeric_limits<double>::epsilon() * bound.extent / bound.absolute;
}

} // namespace meshbound
