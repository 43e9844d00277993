#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

namespace meshbound {

/// No half-edge, no triangle, no vertex, no edge.
inline constexpr std::uint32_t no_index = std::numeric_limits<std::uint32_t>::max();

/// An int that is not negative, such as a ring index, as an index into a container.
inline std::size_t to_index(int i) { return static_cast<std::size_t>(i); }

} // namespace meshbound
