#pragma once

#include "meshbound/bounds.hpp"

namespace meshbound {

/// How far rounding can push an error beyond the bound, as a ratio to the bound: an error is a difference of
/// interpolated values, a few dozen operations on numbers no larger than the extent. 0 where the variable is free.
double rounding_margin(const ResolvedBound& bound);

/// Above this margin a bound is refused as too fine: the guarantee would rest on rounding noise.
inline constexpr double largest_rounding_margin = 1e-3;

} // namespace meshbound
