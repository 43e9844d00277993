#pragma once

#include <cstddef>

namespace meshbound {

/// A ring position, or another number that is never negative where it is used, as an index.
inline std::size_t at(int i) { return static_cast<std::size_t>(i); }

} // namespace meshbound
